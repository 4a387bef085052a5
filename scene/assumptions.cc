#include "scene/assumptions.h"

#include "io/files/key_list.h"
#include "io/files/text.h"
#include "io/files/toml_reader.h"
#include "scene/bearing_catalogue.h"
#include "scene/bearing_keys.h"
#include "scene/keys.h"
#include <algorithm>

namespace rimpact::scene {
namespace {

std::vector<KeyEntry> numbers_of(const Bearing &bearing, bool every) {
  KeyList list("", every);
  Bearing copy = bearing;
  visit(list, copy);
  std::erase_if(list.entries, [](const KeyEntry &entry) { return !entry.is_number; });
  return list.entries;
}

/// A comment that begins with the word; "no assumption" is none.
bool is_mark(const std::string &comment) {
  const std::string words = upper(trim(comment));
  return words.starts_with("ASSUMPTION") || words.starts_with("ASSUMED");
}

} // namespace

bool is_marked(const TomlFile &file, const std::string &path) {
  return is_mark(file.comment_of(path)) || is_mark(file.comment_of_table(path));
}

bool load_is_assumed(const Scene &scene) {
  return scene.load_remark.ends_with(assumed_load);
}

bool has_default_pad(const Bearing &bearing) {
  const auto names = builtin_bearing_names();
  const auto is_of = [&](const std::string &name) {
    const Bearing known = builtin_bearing(name);
    return bearing.surface == known.surface && bearing.slider.diameter == known.slider.diameter;
  };
  const auto &marks = bearing.assumed.keys;
  return bearing.pad == Pad{} && marks.count("pad.outer_radius_mm") > 0 && marks.count("pad.thickness_mm") > 0 &&
         std::none_of(names.begin(), names.end(), is_of);
}

AssumedKeys catalogue_marks() {
  AssumedKeys marks;
  for (const auto &entry : numbers_of({}, true))
    if (entry.key.assumption) marks.keys.insert(entry.path());
  return marks;
}

AssumedKeys every_number() {
  AssumedKeys marks;
  for (const auto &entry : numbers_of({}, true)) marks.keys.insert(entry.path());
  return marks;
}

void read_marks(const TomlFile &file, TomlReader &reader, const std::string &prefix, Bearing &bearing) {
  std::map<std::string, bool> listed;
  std::vector<std::pair<std::string, bool *>> words;
  for (const auto &entry : numbers_of(bearing, true)) words.emplace_back(entry.path(), &listed[entry.path()]);
  reader.switches({"assumed"}, words);
  for (const auto &[key, is_listed] : listed) {
    const bool given = file.find(prefix + key) != nullptr;
    if (is_listed || (given && is_marked(file, prefix + key)))
      bearing.assumed.keys.insert(key);
    else if (given)
      bearing.assumed.keys.erase(key);
  }
}

std::vector<Assumption> assumptions(const Bearing &bearing) {
  std::vector<Assumption> list;
  for (const auto &entry : numbers_of(bearing, false)) {
    if (bearing.assumed.keys.count(entry.path()) == 0) continue;
    std::string value = entry.value;
    if (value.ends_with(".0")) value.resize(value.size() - 2);
    list.push_back({entry.path(), value});
  }
  return list;
}

} // namespace rimpact::scene

#include "app/words/key_catalogue.h"

#include "app/words/key_describer.h"
#include "io/files/key_list.h"
#include "io/files/toml_reader.h"
#include "scene/bearing_keys.h"
#include "scene/keys.h"
#include "scene/scene_keys.h"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>

namespace rimpact::app {
namespace {

void visit_all(KeyVisitor &visitor, scene::Scene &scene) {
  visitor.section("bearing", [&] { scene::visit(visitor, scene.bearing); });
  scene::visit_settings(visitor, scene);
}

/// Keys that count in a scene of these settings.
std::set<std::string> relevant(const std::vector<std::string> &settings) {
  scene::Scene scene;
  TomlFile file("", "");
  for (const auto &setting : settings) file.set(setting);
  TomlReader reader(file, "");
  visit_all(reader, scene);
  KeyList list;
  visit_all(list, scene);
  std::set<std::string> paths;
  for (const auto &entry : list.entries) paths.insert(entry.path());
  return paths;
}

/// When a key counts, where no choice says it.
std::string without_choice(const std::string &path) {
  if (path.starts_with("model.own_mesh.groups.")) return "the file's groups have other names";
  if (path.starts_with("model.own_mesh.")) return "model.own_mesh.file is given";
  return "it is given";
}

/// A choice of [isolator] is tried with the model that reads all of it.
std::vector<std::string> settings_of(const std::string &path, const std::string &word) {
  std::vector<std::string> settings{fmt::format("{}=\"{}\"", path, word)};
  if (path.starts_with("isolator."))
    settings.push_back(fmt::format("reduced.model=\"{}\"", rimpact::word(scene::ModelKind::lir_dcfp)));
  return settings;
}

/// What the keys that do not always count depend on: every choice is tried with each of its words.
void find_conditions(const KeyDescriber &describer, std::vector<KeyDescription> &keys) {
  auto choices = describer.choices;
  choices.emplace_back("reduced.model", words<scene::ModelKind>()); // a text: models are a catalogue
  for (const auto &[path, words] : choices) {
    std::map<std::string, std::vector<std::string>> words_of; // by key
    for (const auto &word : words)
      for (const auto &key : relevant(settings_of(path, word))) words_of[key].push_back(word);
    for (auto &key : keys)
      if (const auto found = words_of.find(key.path); found != words_of.end() && found->second.size() < words.size())
        key.condition +=
            fmt::format("{}{} = {}", key.condition.empty() ? "" : "; ", path, fmt::join(found->second, " | "));
  }
  const auto always = relevant({});
  for (auto &key : keys)
    if (key.condition.empty() && always.count(key.path) == 0) key.condition = without_choice(key.path);
  for (auto &key : keys) key.condition += key.counts_also;
}

/// A triple pendulum's inner rims have the element of [reduced] once more: what counts there counts here, by their own
/// law.
void take_conditions_of_reduced(std::vector<KeyDescription> &keys) {
  const std::string inner = scene::inner_rims_section + ".", reduced = scene::reduced_section + ".";
  for (auto &key : keys) {
    if (key.path == scene::own_rims_key) key.condition = "reduced.model = tfp";
    if (!key.path.starts_with(inner)) continue;
    const std::string name = key.path.substr(inner.size());
    const auto like =
        std::find_if(keys.begin(), keys.end(), [&](const auto &other) { return other.path == reduced + name; });
    std::string condition = like == keys.end() ? "" : like->condition;
    if (const auto at = condition.find(reduced); at != std::string::npos) condition.replace(at, reduced.size(), inner);
    key.condition = name == "calibration" ? "reduced.model = tfp" : scene::own_rims_key + " = true";
    if (!condition.empty()) key.condition += "; " + condition;
  }
}

} // namespace

std::vector<KeyDescription> scene_keys() {
  KeyDescriber describer;
  scene::Scene scene;
  visit_all(describer, scene);
  const auto presets = presets_of([&](KeyVisitor &visitor) { visit_all(visitor, scene); });
  std::vector<KeyDescription> keys = describer.keys;
  for (auto &key : keys)
    if (key.preset.empty()) key.preset = presets.at(key.path);
  find_conditions(describer, keys);
  take_conditions_of_reduced(keys);
  for (const auto &[path, meaning] :
       {std::pair{"name", "of the scene; default: the file's"},
        {"bearing.name", "a built-in bearing, or that of your own"},
        {"bearing.file", "a bearing file beside the scene; keys of [bearing] override it"}})
    keys.insert(keys.begin(), {path, "text", "", "\"\"", "text", meaning, false, ""});
  keys.insert(keys.begin() + 3, {"bearing.assumed", "switches", "", "[]", "any number's key",
                                 "keys to be marked as assumptions", false, ""});
  return keys;
}

} // namespace rimpact::app

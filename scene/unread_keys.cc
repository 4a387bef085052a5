#include "scene/unread_keys.h"
#include "files/key_list.h"
#include "files/path_visitor.h"
#include "scene/keys.h"
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>

namespace rimpact::scene {
namespace {

/// Of which a part of the settings depends.
struct ScenePart {
  const char *prefix, *choice;
};
constexpr std::array parts{ScenePart{"excitation.", "excitation.kind"}, ScenePart{"isolator.", "reduced.model"},
                           ScenePart{"superstructure.", "superstructure.kind"},
                           ScenePart{"reduced.", "reduced.impact_law"}};

const ScenePart *part_of(const std::string &path) {
  const auto found =
      std::find_if(parts.begin(), parts.end(), [&](const ScenePart &part) { return path.starts_with(part.prefix); });
  return found == parts.end() ? nullptr : &*found;
}

/// The names alone of the keys that matter: values as text would cost a fleet's run a tenth of its time.
class NamesRead final : public PathVisitor {
public:
  std::set<std::string> names;

  void number(const Key &key, double &, Unit, Range) override { add(key); }
  void limit(const Key &key, std::optional<double> &, Unit, Range) override { add(key); }
  void integer(const Key &key, int &, int, int) override { add(key); }
  void flag(const Key &key, bool &) override { add(key); }
  void text(const Key &key, std::string &) override { add(key); }
  void word(const Key &key, std::string &, const std::vector<std::string> &) override { add(key); }
  void pair(const Key &key, Eigen::Vector2d &, Range) override { add(key); }
  void numbers(const Key &key, std::vector<double> &, Unit, Range) override { add(key); }
  void switches(const Key &key, const std::vector<std::pair<std::string, bool *>> &) override { add(key); }

private:
  void add(const Key &key) { names.insert(path(key)); }
};

std::vector<KeyEntry> keys_of(Scene scene, bool every) {
  KeyList list("", every);
  visit_settings(list, scene);
  return std::move(list.entries);
}

} // namespace

std::string unread_keys(const TomlFile &file, const Scene &scene) {
  NamesRead read;
  Scene copy = scene;
  visit_settings(read, copy);
  static const auto presets = [] {
    std::map<std::string, std::string> values;
    for (const auto &entry : keys_of({}, true)) values[entry.path()] = entry.value;
    return values;
  }();
  std::vector<std::string> unread;
  for (const auto &[path, preset] : presets) {
    const ScenePart *part = part_of(path);
    if (!part || read.names.count(path) > 0 || !file.find(path)) continue;
    if (path == "reduced.calibration") continue; // read before the settings are
    if (file.is_set(path) || !file.is_set(part->choice)) unread.push_back(path);
  }
  if (unread.empty()) return {};
  std::map<std::string, std::string> values;
  for (const auto &entry : keys_of(scene, true)) values[entry.path()] = entry.value;
  std::erase_if(unread, [&](const std::string &path) { return values[path] == presets.at(path); });
  if (unread.empty()) return {};
  return fmt::format("{} {} not read by this scene: excitation.kind is \"{}\", reduced.model \"{}\", "
                     "reduced.impact_law \"{}\", superstructure.kind \"{}\"",
                     fmt::join(unread, ", "), unread.size() > 1 ? "are" : "is", word(scene.excitation.kind),
                     word(scene.reduced.model), scene.reduced.impact_law->name, word(scene.superstructure.kind));
}

} // namespace rimpact::scene

#include "scene/toml_writer.h"

#include "io/files/key_list.h"
#include "scene/assumptions.h"
#include "scene/bearing_keys.h"
#include "scene/keys.h"
#include "scene/scene_keys.h"
#include <fmt/format.h>
#include <set>

namespace rimpact::scene {
namespace {

/// Every key with its value, its comment behind it; a table's header where another table begins.
std::string to_text(const std::vector<KeyEntry> &entries, const std::set<std::string> &assumed) {
  std::string text, section;
  for (const auto &entry : entries) {
    if (entry.section != section) text += fmt::format("\n[{}]\n", entry.section);
    section = entry.section;
    const std::string line = fmt::format("{} = {}", entry.key.name, entry.value);
    const bool marked = assumed.count(entry.path()) > 0;
    const char *joint = marked && *entry.key.comment ? ": " : "";
    const std::string comment = fmt::format("{}{}{}", marked ? "assumption" : "", joint, entry.key.comment);
    text += comment.empty() ? line + "\n" : fmt::format("{:<32} # {}\n", line, comment);
  }
  return text;
}

} // namespace

std::string to_toml(const Bearing &bearing) {
  KeyList list;
  Bearing copy = bearing;
  visit(list, copy);
  return fmt::format("name = {}\n{}", toml_quoted(bearing.name), to_text(list.entries, bearing.assumed.keys));
}

std::string to_toml(const Scene &scene) {
  KeyList bearing("bearing"), settings;
  Scene copy = scene;
  visit(bearing, copy.bearing);
  visit_settings(settings, copy);
  std::set<std::string> assumed;
  for (const auto &key : scene.bearing.assumed.keys) assumed.insert("bearing." + key);
  if (load_is_assumed(scene)) assumed.insert({"load.vertical_kN", "load.mass_kg"});
  return fmt::format("name = {}\n\n[bearing]\nname = {}\n{}{}", toml_quoted(scene.name),
                     toml_quoted(scene.bearing.name), to_text(bearing.entries, assumed),
                     to_text(settings.entries, assumed));
}

} // namespace rimpact::scene

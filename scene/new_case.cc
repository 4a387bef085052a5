#include "scene/new_case.h"

#include "io/files/key_list.h"
#include "io/files/text.h"
#include "io/files/toml_reader.h"
#include "scene/keys.h"
#include "scene/scene_catalogue.h"
#include "scene/scene_keys.h"
#include "scene/toml_writer.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

/// Written by a calibration, not by hand.
bool is_of_a_calibration(const std::string &name) {
  return name.starts_with("fitted_") || name == "taken_from";
}

/// The built-in scene with its defaults; without its records where they are the user's to bring.
Scene scene_named(const TomlFile &file, const std::string &name) {
  try {
    return load_scene(name);
  } catch (const DataError &) {
    Scene scene;
    TomlReader reader(file, "");
    visit_settings(reader, scene);
    return scene;
  }
}

/// Lines of a section's keys that the file leaves out, as comments.
std::string left_out(const TomlFile &file, const std::string &section, bool every, Scene scene) {
  KeyList list("", every);
  visit_settings(list, scene);
  std::string text;
  for (const auto &entry : list.entries) {
    if (entry.section != section || file.find(entry.path()) || is_of_a_calibration(entry.key.name)) continue;
    if (scene.excitation.kind == ExcitationKind::record && entry.path() == "excitation.duration_s")
      continue; // the record's own
    const std::string line = fmt::format("# {} = {}", entry.key.name, entry.value);
    text += *entry.key.comment ? fmt::format("{:<34} # {}\n", line, entry.key.comment) : line + "\n";
  }
  return text;
}

/// Puts lines at the end of a section of the text; a section that is not there is begun.
void put(std::string &text, const std::string &section, const std::string &lines) {
  if (lines.empty()) return;
  const std::string header = fmt::format("[{}]", section);
  const auto at = text.starts_with(header) ? 0 : text.find(fmt::format("\n{}", header));
  if (at == std::string::npos) {
    text += fmt::format("\n{}\n{}", header, lines);
    return;
  }
  auto end = text.find("\n[", at + 1);
  end = end == std::string::npos ? text.size() : end;
  while (end > 0 && text[end - 1] == '\n') --end; // in front of the blank line
  text.insert(end, fmt::format("\n{}", trim(lines)));
}

/// The mass as a comment, where it follows from the weight: a weight changed must not leave another's mass behind.
std::string mass_line(const Load &load) {
  return fmt::format("# mass_kg = {:<22} # inertia; left out, it is the dead load over gravity",
                     file_number(load.vertical / load.gravity, si));
}

bool mass_follows(const Load &load) {
  constexpr double rounding = 1e-4; // of a mass as scenes write it
  return std::abs(load.vertical / (load.mass * load.gravity) - 1) < rounding;
}

/// Its [bearing] is the file beside it.
void name_file(std::string &text) {
  const std::string place = "name = \"shfps-225\"", beside = "file = \"bearing.toml\"";
  if (const auto at = text.find(place); at != std::string::npos)
    text.replace(at, place.size(), beside);
  else
    text = "[bearing]\n" + beside + "\n\n" + text;
}

/// Gives the text a [load] with one of the two keys, if they say the same.
void put_load(std::string &text, bool has_load, const Load &load) {
  if (!has_load)
    put(text, "load",
        fmt::format("vertical_kN = {:<20} # dead load\n{}\n", file_number(load.vertical, kilo), mass_line(load)));
  const auto at = has_load && mass_follows(load) ? text.find("\nmass_kg = ") : std::string::npos;
  if (at != std::string::npos) text.replace(at + 1, text.find('\n', at + 1) - at - 1, mass_line(load));
}

} // namespace

CaseFiles new_case(const std::string &name, const std::string &bearing, const std::string &scene) {
  std::string text = builtin_scene_text(scene);
  const BuiltinScene *entry = find_builtin_scene(scene);
  const TomlFile file(entry ? entry->text : "", scene);
  const Scene defaults = scene_named(file, scene);
  Bearing own = load_bearing(bearing);
  own.name = name;
  if (!defaults.rigid_bodies()) name_file(text);
  put_load(text, file.find("load") != nullptr, defaults.load);
  put(text, "excitation", left_out(file, "excitation", false, defaults));
  put(text, "reduced", left_out(file, "reduced", true, defaults));
  const std::string head =
      "# A number marked \"assumption\" was chosen by us, for no document gives it. Put yours in its place and "
      "strike the mark: reports list those left.\n";
  return {defaults.rigid_bodies() ? "" : head + to_toml(own), text};
}

} // namespace rimpact::scene

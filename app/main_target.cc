#include "app/main_target.h"

#include "files/error.h"
#include "files/file.h"
#include "files/key_list.h"
#include "files/text.h"
#include "files/toml_reader.h"
#include "scene/case_description.h"
#include "scene/rim_identity.h"
#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The text to parse as a scene, and whether the user wrote it.
struct Source {
  std::string text, origin, folder = ".";
  std::string bearing_file = {}; ///< what was given is a bearing of its own: its name or file
  bool built_in = false;
};

bool among(const std::vector<std::string> &names, const std::string &name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// A scene that consists of a bearing alone.
Source scene_around(const std::string &key, const std::string &bearing, bool built_in) {
  return {.text = fmt::format("name = \"main\"\n[bearing]\n{} = {}\n", key, toml_quoted(bearing)),
          .origin = bearing,
          .bearing_file = bearing,
          .built_in = built_in};
}

bool holds_any(const TomlFile &file, const auto &tables) {
  return std::any_of(tables.begin(), tables.end(), [&](const char *name) { return file.find(name) != nullptr; });
}

Source from_file(const fs::path &path) {
  constexpr std::array of_a_scene{"bearing", "load", "excitation", "model", "reduced"};
  constexpr std::array of_a_bearing{"surface", "slider", "rim", "plate", "pad", "foot", "material", "contact"};
  const std::string text = read_named_file(path.string());
  const TomlFile file(text, path.string());
  const bool scene = holds_any(file, of_a_scene), bearing = holds_any(file, of_a_bearing);
  if (scene && bearing)
    throw InputError(fmt::format("{}: holds tables of a scene ([bearing], [load], [excitation], [model], [reduced]) "
                                 "and of a bearing ([surface], [slider], [rim], ...) "
                                 "at once; in a scene the bearing's tables are [bearing.rim] and so on",
                                 path.string()));
  if (!scene && !bearing)
    throw InputError(fmt::format("{}: neither a scene ([bearing], [load], [excitation], [model], [reduced]) nor a "
                                 "bearing ([surface], [slider], [rim], ...); `rimpact new DIR` writes both",
                                 path.string()));
  if (bearing) {
    scene::load_bearing(path.string()); // its mistakes are named by its own lines
    return scene_around("file", path.string(), false);
  }
  return {.text = text, .origin = path.string(), .folder = path.parent_path().string()};
}

Source source_of(const std::string &where) {
  if (among(scene::builtin_bearing_names(), where)) return scene_around("name", where, true);
  if (among(scene::builtin_scene_names(), where))
    return {.text = scene::builtin_scene_text(where), .origin = where, .built_in = true};
  std::error_code ignored;
  fs::path path = where;
  if (fs::is_directory(path, ignored)) path /= fs::exists(path / "scene.toml", ignored) ? "scene.toml" : "bearing.toml";
  if (fs::exists(path, ignored)) return from_file(path);
  auto names = scene::builtin_bearing_names();
  for (auto &name : scene::builtin_scene_names()) names.push_back(name);
  throw InputError(fmt::format("{}: no such file, and bearing or scene {}", path.string(), not_among(where, names)));
}

std::string origin_of(const TomlFile &file, const std::string &key, const char *otherwise) {
  return file.find(key) ? file.location(key) : otherwise;
}

std::string bearing_origin(const TomlFile &file, const Source &source, const std::vector<std::string> &overrides) {
  std::string from = source.bearing_file;
  if (!from.empty())
    from = source.built_in ? "built-in" : from;
  else if (const auto *named = file.find("bearing.file"); named && named->is_string())
    from = (fs::path(source.folder) / named->as_string()->get()).lexically_normal().string() + ", named by " +
           source.origin;
  else if (file.find("bearing"))
    from = source.origin;
  else
    from = "default: " + source.origin + " names none";
  for (const auto &assignment : overrides)
    if (assignment.rfind("bearing.", 0) == 0) from += ", --set " + assignment;
  return from;
}

void refuse_what_is_not_run(const scene::Scene &scene, const std::vector<std::string> &overrides) {
  for (const auto &assignment : overrides)
    if (assignment.rfind("excitation.", 0) == 0)
      throw InputError(
          "--set " + assignment +
          ": the motions of main are its own: --speeds and --pulse-speeds choose them, `rimpact run` runs a scene's");
  if (scene.double_concave())
    throw InputError("reduced.model \"" + word(scene.reduced.model) +
                     "\": main is for a bearing with one dish; `rimpact reduced` runs this scene");
  if (scene.superstructure.any())
    throw InputError(
        "superstructure.kind \"" + word(scene.superstructure.kind) +
        "\": main runs the bearing under a rigid mass; leave [superstructure] out, its mass is in load.mass_kg");
}

/// A load that nobody gave is the thesis's, and hardly that of another bearing.
void judge_load(MainTarget &target, bool vertical_given, bool mass_given) {
  if (vertical_given || mass_given || target.scene.bearing == scene::builtin_bearing("shfps-225")) return;
  const auto &load = target.scene.load;
  target.warnings.push_back(
      fmt::format("no load is given for bearing {}: it runs under load.vertical_kN = {:g} and load.mass_kg = {:g}, "
                  "those of shfps-225; "
                  "give yours by --set load.vertical_kN=... --set load.mass_kg=..., or a scene with [load]",
                  target.scene.bearing.name, load.vertical / 1e3, load.mass));
}

} // namespace

MainTarget main_target(const std::string &where, const std::vector<std::string> &overrides) {
  const Source source = source_of(where);
  MainTarget target;
  TomlFile file(source.text, source.origin);
  for (const auto &assignment : overrides) file.set(assignment);
  auto settings = overrides;
  if (!file.find("excitation.kind"))
    settings.emplace_back("excitation.kind=window"); // no motion is run: none is to be remarked upon
  target.scene = scene::parse_scene(source.text, source.origin, settings, source.folder);
  refuse_what_is_not_run(target.scene, overrides);
  target.warnings = target.scene.remarks;
  target.bearing_from = bearing_origin(file, source, overrides);
  const bool vertical = file.find("load.vertical_kN") != nullptr, mass = file.find("load.mass_kg") != nullptr;
  target.vertical_from = origin_of(file, "load.vertical_kN", mass ? "load.mass_kg times gravity" : "default");
  target.mass_from = origin_of(file, "load.mass_kg", vertical ? "load.vertical_kN over gravity" : "default");
  judge_load(target, vertical, mass);
  const bool asked = std::any_of(overrides.begin(), overrides.end(),
                                 [](const auto &each) { return each.rfind("model.rung", 0) == 0; });
  if (!asked && (source.built_in || !file.find("model.rung"))) target.scene.model.rung = scene::Rung::rim;
  if (!source.built_in && file.find("excitation"))
    target.remarks.push_back(fmt::format(
        "the motion of {} ({}) is not run: main runs windows and Ricker pulses of its own; `rimpact run` runs it",
        source.origin, word(target.scene.excitation.kind)));
  return target;
}

json MainTarget::bearing_json() const {
  return {{"name", scene.bearing.name},
          {"rim_identity", scene::rim_identity(scene.bearing)},
          {"lateral_capacity_m", scene.bearing.lateral_capacity()},
          {"from", bearing_from}};
}

json MainTarget::load_json() const {
  return {{"vertical_kN", scene.load.vertical / 1e3},
          {"mass_kg", scene.load.mass},
          {"gravity", scene.load.gravity},
          {"vertical_from", vertical_from},
          {"mass_from", mass_from}};
}

std::string MainTarget::head() const {
  const auto &b = scene.bearing;
  return fmt::format("bearing {} ({}): L_c = {:.1f} mm, slider {:g} mm, {}, rung {}, mesh {}\n"
                     "load: dead load {:g} kN ({}), supported mass {:.6g} kg ({})\n",
                     b.name, bearing_from, 1e3 * b.lateral_capacity(), 1e3 * b.slider.diameter, scene::rim_in_words(b),
                     word(scene.model.rung), scene.model.mesh, scene.load.vertical / 1e3, vertical_from,
                     scene.load.mass, mass_from);
}

} // namespace rimpact::app

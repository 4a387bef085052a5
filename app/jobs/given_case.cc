#include "app/jobs/given_case.h"

#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/key_list.h"
#include "io/files/text.h"
#include "io/files/toml_reader.h"
#include "scene/assumptions.h"
#include "scene/bearing_catalogue.h"
#include "scene/case_description.h"
#include "scene/isolator_catalogue.h"
#include "scene/rim_identity.h"
#include "scene/solid_bearing.h"
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
  scene::refuse_isolator(where);
  auto names = scene::builtin_bearing_names();
  for (auto &name : scene::builtin_scene_names()) names.push_back(name);
  throw InputError(fmt::format("{}: no such file, and bearing or scene {}", path.string(), unknown_word(where, names)));
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

/// A load that nobody gave is the thesis's, and hardly that of another bearing.
std::string doubt_of_load(const scene::Scene &scene) {
  if (!scene::load_is_assumed(scene) || scene.bearing == scene::builtin_bearing("shfps-225")) return {};
  const bool is_thesis = scene.load.vertical == scene::Load{}.vertical && scene.load.mass == scene::Load{}.mass;
  return fmt::format("no load is given for bearing {}: it runs under load.vertical_kN = {:g} and load.mass_kg = {:g}, "
                     "{}; give yours by --set load.vertical_kN=..., or a scene with [load]",
                     scene.bearing.name, scene.load.vertical / 1e3, scene.load.mass,
                     is_thesis ? "the thesis's of shfps-225, an assumption" : "an assumption");
}

} // namespace

GivenCase given_case(const std::string &where, const std::vector<std::string> &overrides) {
  const Source source = source_of(where);
  GivenCase given;
  TomlFile file(source.text, source.origin);
  for (const auto &assignment : overrides) file.set(assignment);
  auto settings = overrides;
  if (!file.find("excitation.kind"))
    settings.emplace_back("excitation.kind=window"); // no motion is run: none is to be remarked upon
  given.scene = scene::parse_scene(source.text, source.origin, settings, source.folder);
  given.origin = source.origin, given.built_in = source.built_in;
  given.has_motion = file.find("excitation") != nullptr, given.has_rung = file.find("model.rung") != nullptr;
  given.bearing_from = bearing_origin(file, source, overrides);
  const bool vertical = file.find("load.vertical_kN") != nullptr, mass = file.find("load.mass_kg") != nullptr;
  const char *otherwise = "default: the thesis's, an assumption";
  given.vertical_from = origin_of(file, "load.vertical_kN", mass ? "load.mass_kg times gravity" : otherwise);
  given.mass_from = origin_of(file, "load.mass_kg", vertical ? "load.vertical_kN over gravity" : otherwise);
  given.warnings = given.scene.remarks;
  if (std::string doubt = doubt_of_load(given.scene); !doubt.empty()) {
    std::erase(given.warnings, given.scene.load_remark); // one sentence about it is enough
    given.warnings.push_back(std::move(doubt));
  }
  return given;
}

json GivenCase::bearing_json() const {
  return {{"name", scene.bearing.name},
          {"rim_identity", scene::rim_identity(scene.bearing)},
          {"lateral_capacity_m", scene.bearing.lateral_capacity()},
          {"from", bearing_from}};
}

json GivenCase::load_json() const {
  return {{"vertical_kN", scene.load.vertical / 1e3}, {"mass_kg", scene.load.mass},     {"gravity", scene.load.gravity},
          {"assumed", scene::load_is_assumed(scene)}, {"vertical_from", vertical_from}, {"mass_from", mass_from}};
}

std::string GivenCase::load_line() const {
  return fmt::format("load: dead load {:g} kN ({}), supported mass {:.6g} kg ({})\n", scene.load.vertical / 1e3,
                     vertical_from, scene.load.mass, mass_from);
}

std::string GivenCase::head() const {
  const auto &b = scene.bearing;
  return fmt::format("bearing {} ({}): L_c = {:.1f} mm, slider {:g} mm, {}, rung {}, mesh {}\n{}", b.name, bearing_from,
                     1e3 * b.lateral_capacity(), 1e3 * b.slider.diameter, scene::rim_in_words(b),
                     word(scene.model.rung), scene.model.mesh, load_line());
}

void require_bearing(const scene::Scene &scene, const std::string &verb) {
  if (const auto reason = scene::without_solid_bearing(scene, verb + " takes")) throw InputError(*reason);
}

} // namespace rimpact::app

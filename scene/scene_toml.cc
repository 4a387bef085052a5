/// Scenes and bearings from TOML: defaults that depend on other keys, files beside the scene, errors with
/// their place.
#include "scene/files.h"
#include "scene/record.h"
#include "scene/scene_catalogue.h"
#include "scene/text.h"
#include "scene/toml_reader.h"
#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

namespace fs = std::filesystem;

/// A TOML file's text; what cannot be read is the command line's fault.
std::string read_toml(const std::string &path) {
  try {
    return read_file(path);
  } catch (const DataError &error) {
    throw InputError(error.what());
  }
}

/// What a scene or bearing is called when its file does not say: the file's name without .toml.
std::string name_from(const std::string &origin) {
  const fs::path path = origin;
  return path.extension() == ".toml" ? path.stem().string() : path.filename().string();
}

/// Material keys that hang together: no yield, no slope past it; yield alone is perfectly plastic.
void settle(Material &m) {
  if (!m.yield)
    m.tangent_modulus.reset();
  else if (!m.tangent_modulus)
    m.tangent_modulus = 0.0;
}

/// Puts the rows of the surface's file in its place, so that a resolved scene runs anywhere. `prefix`: of the
/// bearing's keys in the file.
void read_table(const TomlFile &file, const std::string &prefix, SurfaceSpec &surface,
                const std::string &folder) {
  if (surface.table_file.empty()) return;
  const std::string name = surface.table_file, key = prefix + "surface.file";
  const auto fail = [&](const std::string &what) {
    throw InputError(fmt::format("{}: {} \"{}\" {}", file.location(key), key, name.substr(0, 200), what));
  };
  if (surface.kind != "table") fail("needs surface.kind \"table\", not \"" + surface.kind + "\"");
  if (file.find(prefix + "surface.radius_mm") || file.find(prefix + "surface.height_mm"))
    fail("stands beside radius_mm or height_mm; give the file or the rows");
  try {
    read_surface_table((fs::path(folder) / name).lexically_normal().string(), surface);
  } catch (const DataError &error) {
    throw DataError(fmt::format("{}: {} {}", file.location(key), key, error.what()));
  }
  surface.table_file.clear();
}

void read_bearing(const TomlFile &file, TomlReader &reader, const std::string &prefix,
                  const std::string &folder, Bearing &bearing) {
  reader.text({"name"}, bearing.name);
  visit(reader, bearing);
  read_table(file, prefix, bearing.surface, folder);
  settle(bearing.steel);
  settle(bearing.ertalyte);
  if (bearing.surface.kind == "sphere") bearing.surface.a = bearing.surface.R0;
}

/// Runs a check whose messages open with a key, and puts the key's place in front.
template <class Check>
void with_location(const TomlFile &file, const std::string &prefix, const Check &check) {
  try {
    check();
  } catch (const InputError &error) {
    const std::string sentence = error.what(), key = sentence.substr(0, sentence.find_first_of(" :"));
    const std::string inner = prefix.empty() ? key : prefix + "." + key;
    const bool in_prefix = file.find(inner) != nullptr;
    throw InputError(fmt::format("{}: {}", file.location(in_prefix ? inner : key), sentence));
  }
}

Bearing parse_bearing(const std::string &text, const std::string &origin) {
  const std::string folder = fs::path(origin).parent_path().string();
  const TomlFile file(text, origin);
  Bearing bearing;
  bearing.name = name_from(origin);
  TomlReader reader(file, "");
  read_bearing(file, reader, "", folder, bearing);
  reader.finish();
  with_location(file, "", [&] { bearing.validate(); });
  return bearing;
}

std::string text_at(const TomlFile &file, const std::string &path) {
  const auto *node = file.find(path);
  return node && node->is_string() ? node->as_string()->get() : "";
}

/// A resolved scene names a bearing of someone's own and writes all its dimensions.
bool is_written_out(const TomlFile &file) {
  constexpr std::array tables{"surface", "slider", "rim", "plate", "pad", "foot", "material", "contact"};
  return std::all_of(tables.begin(), tables.end(),
                     [&](const char *name) { return file.find(std::string("bearing.") + name) != nullptr; });
}

/// The bearing that [bearing] starts from, before its overrides.
Bearing base_bearing(const TomlFile &file, const std::string &folder) {
  const std::string name = text_at(file, "bearing.name"), path = text_at(file, "bearing.file");
  if (!path.empty()) {
    const std::string full = (fs::path(folder) / path).lexically_normal().string();
    try {
      return parse_bearing(read_toml(full), full);
    } catch (const InputError &error) {
      throw InputError(fmt::format("{}: bearing.file: {}", file.location("bearing.file"), error.what()));
    }
  }
  if (name.empty()) return builtin_bearing("shfps-225");
  const auto names = builtin_bearing_names();
  if (std::find(names.begin(), names.end(), name) == names.end() && is_written_out(file)) return {};
  try {
    return builtin_bearing(name);
  } catch (const InputError &error) {
    throw InputError(fmt::format("{}: {}", file.location("bearing.name"), error.what()));
  }
}

void set_dependent_defaults(const TomlFile &file, Scene &scene) {
  auto &e = scene.excitation;
  const auto given = [&](const char *path) { return file.find(path) != nullptr; };
  const bool window = e.kind == ExcitationKind::window;
  if (!given("excitation.centre_s")) e.centre = window ? 0.0 : 2 * e.period;
  if (!given("excitation.duration_s")) {
    e.duration = window ? 0.2 : 2 * e.period + 6;
    const bool has_record = !e.x.values.empty() || !e.y.values.empty() || !e.z.values.empty();
    if (e.kind == ExcitationKind::record && has_record)
      e.duration = std::max({e.x.end(), e.y.end(), e.z.end()});
  }
  if (!given("excitation.amplitude_m") && e.kind == ExcitationKind::figure_eight) e.amplitude = 0.31;
  if (!given("isolator.points") && scene.isolator.space == "spatial") scene.isolator.points = 8;
  if (!given("reduced.mu_fast")) scene.reduced.mu_fast = scene.bearing.contact.steel_ertalyte;
  if (!given("reduced.mu_slow")) scene.reduced.mu_slow = scene.reduced.mu_fast;
}

/// A file beside the scene, by its absolute name: a resolved scene runs anywhere.
void make_absolute(std::string &name, const std::string &folder) {
  std::error_code ignored;
  const fs::path absolute = fs::absolute(fs::path(folder) / name, ignored);
  if (!ignored) name = absolute.lexically_normal().string();
}

/// Reads the records a scene names; afterwards their names are absolute.
void read_records(const TomlFile &file, Scene &scene, const std::string &folder) {
  auto &e = scene.excitation;
  if (e.kind != ExcitationKind::record) return;
  const auto read = [&](const char *axis, std::string &name, SampledSignal &signal) {
    if (name.empty()) return;
    const std::string key = std::string("excitation.") + axis;
    if (!is_builtin_record(name)) make_absolute(name, folder);
    try {
      signal = read_record(name, scene.load.gravity);
    } catch (const InputError &error) {
      throw InputError(fmt::format("{}: {} {}", file.location(key), key, error.what()));
    } catch (const DataError &error) {
      throw DataError(fmt::format("{}: {} {}", file.location(key), key, error.what()));
    }
  };
  read("x", e.x_file, e.x);
  read("y", e.y_file, e.y);
  read("z", e.z_file, e.z);
}

} // namespace

Scene parse_scene(const std::string &text, const std::string &origin,
                  const std::vector<std::string> &overrides, const std::string &folder) {
  TomlFile file(text, origin);
  for (const auto &assignment : overrides) file.set(assignment);
  Scene scene;
  scene.name = name_from(origin);
  TomlReader reader(file, "");
  reader.text({"name"}, scene.name);
  reader.section("bearing", [&] {
    scene.bearing = base_bearing(file, folder);
    std::string bearing_file;
    reader.text({"file"}, bearing_file);
    read_bearing(file, reader, "bearing.", folder, scene.bearing);
  });
  visit_settings(reader, scene);
  reader.finish();
  // Geometry first: a bearing that cannot be built is said before a record that is missing.
  with_location(file, "bearing", [&] { scene.bearing.validate(); });
  read_records(file, scene, folder);
  if (scene.model.own_mesh.any()) make_absolute(scene.model.own_mesh.file, folder);
  set_dependent_defaults(file, scene);
  with_location(file, "bearing", [&] { scene.validate(); });
  return scene;
}

void check_assignment(const std::string &assignment, const std::string &where) {
  TomlFile file("", where);
  file.set(assignment, where);
  Scene scene;
  std::string bearing_file;
  TomlReader reader(file, "");
  reader.text({"name"}, scene.name);
  reader.section("bearing", [&] { // the keys alone: what they mean together is the whole scene's matter
    reader.text({"file"}, bearing_file);
    reader.text({"name"}, scene.bearing.name);
    visit(reader, scene.bearing);
  });
  visit_settings(reader, scene);
  reader.finish();
}

Bearing load_bearing(const std::string &where) {
  const auto names = builtin_bearing_names();
  if (std::find(names.begin(), names.end(), where) != names.end()) return builtin_bearing(where);
  std::error_code ignored;
  if (!fs::exists(where, ignored))
    throw InputError(fmt::format("{}: no such file, and bearing {}", where, not_among(where, names)));
  return parse_bearing(read_toml(where), where);
}

Scene load_scene(const std::string &where, const std::vector<std::string> &overrides) {
  if (const auto *entry = find_builtin_scene(where)) {
    try {
      return parse_scene(entry->text, where, overrides);
    } catch (const DataError &error) {
      throw DataError(entry->needs.empty() ? error.what()
                                           : fmt::format("{} ({})", entry->needs, error.what()));
    }
  }
  std::error_code ignored;
  fs::path path = where;
  if (fs::is_directory(path, ignored)) path /= "scene.toml";
  if (!fs::exists(path, ignored))
    throw InputError(fmt::format("{}: no such file, and scene {}", path.string(),
                                 not_among(where, builtin_scene_names())));
  Scene scene = parse_scene(read_toml(path.string()), path.string(), overrides, path.parent_path().string());
  return scene;
}

} // namespace rimpact::scene

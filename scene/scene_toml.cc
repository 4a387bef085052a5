/// Scenes and bearings from TOML: defaults that depend on other keys, files beside the scene, errors with
/// their place.
#include "files/file.h"
#include "files/text.h"
#include "files/toml_reader.h"
#include "records/record_library.h"
#include "scene/assumptions.h"
#include "scene/calibrated_element.h"
#include "scene/file_kind.h"
#include "scene/keys.h"
#include "scene/scene_catalogue.h"
#include "scene/scene_defaults.h"
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

/// Puts the rows of the surface's file in its place, so that a resolved scene runs anywhere. `prefix`: of the
/// bearing's keys in the file.
void read_table(const TomlFile &file, const std::string &prefix, SurfaceSpec &surface, const std::string &folder) {
  if (surface.table_file.empty()) return;
  const std::string name = surface.table_file, key = prefix + "surface.file";
  const auto fail = [&](const std::string &what) {
    throw InputError(fmt::format("{}: {} \"{}\" {}", file.location(key), key, name.substr(0, 200), what));
  };
  if (surface.kind != SurfaceKind::table) fail("needs surface.kind \"table\", not \"" + word(surface.kind) + "\"");
  if (file.find(prefix + "surface.radius_mm") || file.find(prefix + "surface.height_mm"))
    fail("stands beside radius_mm or height_mm; give the file or the rows");
  try {
    read_surface_table((fs::path(folder) / name).lexically_normal().string(), surface);
  } catch (const DataError &error) {
    throw DataError(fmt::format("{}: {} {}", file.location(key), key, error.what()));
  }
  surface.table_file.clear();
}

void read_bearing(const TomlFile &file, TomlReader &reader, const std::string &prefix, const std::string &folder,
                  Bearing &bearing) {
  reader.text({"name"}, bearing.name);
  visit(reader, bearing);
  read_marks(file, reader, prefix, bearing);
  read_table(file, prefix, bearing.surface, folder);
  set_dependent_defaults(file, prefix, bearing);
}

/// Runs a check whose messages open with a key, and puts the key's place in front.
template <class Check> void with_location(const TomlFile &file, const std::string &prefix, const Check &check) {
  try {
    check();
  } catch (const InputError &error) {
    const std::string sentence = error.what(), key = sentence.substr(0, sentence.find_first_of(" :"));
    const std::string inner = prefix.empty() ? key : prefix + "." + key;
    const bool in_prefix = file.find(inner) != nullptr;
    throw InputError(fmt::format("{}: {}", file.location(in_prefix ? inner : key), sentence));
  }
}

/// `whole`: pad and foot are checked too.
Bearing parse_bearing(const std::string &text, const std::string &origin, bool whole) {
  const std::string folder = fs::path(origin).parent_path().string();
  const TomlFile file(text, origin);
  require_bearing(file);
  Bearing bearing;
  bearing.name = name_from(origin);
  bearing.assumed = every_number();
  TomlReader reader(file, "");
  read_bearing(file, reader, "", folder, bearing);
  reader.finish();
  with_location(file, "", [&] { whole ? bearing.validate() : bearing.validate_rim(); });
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

/// Whether the scene models pad and foot, before its settings are read.
bool models_stack(const TomlFile &file) {
  const auto rung = parse<Rung>(text_at(file, "model.rung"));
  const auto on = [&](const char *key) {
    const auto *node = file.find(key);
    return node && node->is_boolean() && node->as_boolean()->get();
  };
  return (rung && rung != Rung::rim) || on("reduced.finite_pad") || on("reduced.socket_friction");
}

bool is_builtin_name(const std::string &name) {
  const auto names = builtin_bearing_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// A bearing of someone's own: from a file, or written out under a name that no built-in one has.
bool has_own_bearing(const TomlFile &file) {
  const std::string name = text_at(file, "bearing.name");
  return !text_at(file, "bearing.file").empty() || (!name.empty() && !is_builtin_name(name) && is_written_out(file));
}

/// The bearing that [bearing] starts from, before its overrides.
Bearing base_bearing(const TomlFile &file, const std::string &folder) {
  const std::string name = text_at(file, "bearing.name"), path = text_at(file, "bearing.file");
  if (!path.empty()) {
    const std::string full = (fs::path(folder) / path).lexically_normal().string();
    try {
      return parse_bearing(read_toml(full), full, models_stack(file));
    } catch (const InputError &error) {
      throw InputError(fmt::format("{}: bearing.file: {}", file.location("bearing.file"), error.what()));
    }
  }
  if (name.empty()) return builtin_bearing("shfps-225");
  if (has_own_bearing(file)) {
    Bearing none_given;
    none_given.assumed = every_number();
    return none_given;
  }
  try {
    return builtin_bearing(name);
  } catch (const InputError &error) {
    throw InputError(fmt::format("{}: {}", file.location("bearing.name"), error.what()));
  }
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
      signal = *shared_record(name, scene.load.gravity);
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

Scene parse_scene(const std::string &text, const std::string &origin, const std::vector<std::string> &overrides,
                  const std::string &folder) {
  TomlFile file(text, origin);
  for (const auto &assignment : overrides) file.set(assignment);
  require_scene(file);
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
  const auto typed = typed_element_keys(file);
  adopt_calibration(file, folder, scene.bearing, scene.remarks);
  visit_settings(reader, scene);
  reader.finish();
  forget_origin(typed, scene.reduced, scene.remarks);
  // Geometry first: a bearing that cannot be built is said before a record that is missing.
  with_location(file, "bearing", [&] { check_bearing(scene); });
  read_records(file, scene, folder);
  if (!scene.reduced.impact_curve.empty()) make_absolute(scene.reduced.impact_curve, folder);
  if (scene.model.own_mesh.any()) make_absolute(scene.model.own_mesh.file, folder);
  set_dependent_defaults(file, has_own_bearing(file), scene);
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
  if (is_builtin_name(where)) return builtin_bearing(where);
  std::error_code ignored;
  if (!fs::exists(where, ignored))
    throw InputError(fmt::format("{}: no such file, and bearing {}", where, not_among(where, builtin_bearing_names())));
  return parse_bearing(read_toml(where), where, false);
}

Scene load_scene(const std::string &where, const std::vector<std::string> &overrides) {
  if (const auto *entry = find_builtin_scene(where)) {
    try {
      return parse_scene(entry->text, where, overrides);
    } catch (const DataError &error) {
      throw DataError(entry->needs.empty() ? error.what() : fmt::format("{} ({})", entry->needs, error.what()));
    }
  }
  std::error_code ignored;
  fs::path path = where;
  if (fs::is_directory(path, ignored)) path /= "scene.toml";
  if (!fs::exists(path, ignored))
    throw InputError(
        fmt::format("{}: no such file, and scene {}", path.string(), not_among(where, builtin_scene_names())));
  Scene scene = parse_scene(read_toml(path.string()), path.string(), overrides, path.parent_path().string());
  return scene;
}

} // namespace rimpact::scene

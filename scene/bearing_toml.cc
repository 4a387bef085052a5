#include "scene/bearing_toml.h"
#include "io/files/file.h"
#include "io/files/table_csv.h"
#include "io/files/text.h"
#include "scene/assumptions.h"
#include "scene/bearing_catalogue.h"
#include "scene/bearing_keys.h"
#include "scene/file_kind.h"
#include "scene/isolator_catalogue.h"
#include "scene/keys.h"
#include "scene/scene_defaults.h"
#include "scene/steel_defaults.h"
#include "scene/surface_table.h"
#include <algorithm>
#include <array>
#include <filesystem>

namespace rimpact::scene {
namespace {

namespace fs = std::filesystem;

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

/// A resolved scene names a bearing of someone's own and writes all its dimensions.
bool is_written_out(const TomlFile &file) {
  constexpr std::array tables{"surface", "slider", "rim", "plate", "material", "contact"};
  constexpr std::array of_one_dish{"pad", "foot"};
  const auto has = [&](const char *name) { return file.find(std::string("bearing.") + name) != nullptr; };
  const bool two_dishes = text_at(file, "bearing.surface.concave") == word(Concave::twice);
  return std::all_of(tables.begin(), tables.end(), has) &&
         (two_dishes || std::all_of(of_one_dish.begin(), of_one_dish.end(), has));
}

/// Whether the scene models pad and foot, before its settings are read.
bool models_stack(const TomlFile &file) {
  const auto rung = parse<Rung>(text_at(file, "model.rung"));
  const auto on = [&](const char *key) {
    const auto *node = file.find(key);
    return node && node->is_boolean() && node->as_boolean()->get();
  };
  return (rung && has_dish(*rung)) || on("reduced.finite_pad") || on("reduced.socket_friction");
}

bool is_builtin_name(const std::string &name) {
  const auto names = builtin_bearing_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

} // namespace

std::string text_at(const TomlFile &file, const std::string &path) {
  const auto *node = file.find(path);
  return node && node->is_string() ? node->as_string()->get() : "";
}

std::string name_from(const std::string &origin) {
  const fs::path path = origin;
  return path.extension() == ".toml" ? path.stem().string() : path.filename().string();
}

void read_bearing(const TomlFile &file, TomlReader &reader, const std::string &prefix, const std::string &folder,
                  Bearing &bearing) {
  reader.text({"name"}, bearing.name);
  visit(reader, bearing);
  read_marks(file, reader, prefix, bearing);
  read_table(file, prefix, bearing.surface, folder);
  read_flow_curve(file, prefix + "material.steel.", bearing.steel.hardening, folder);
  set_dependent_defaults(file, prefix, bearing);
  read_part_steels(file, prefix, folder, bearing);
}

bool has_own_bearing(const TomlFile &file) {
  const std::string name = text_at(file, "bearing.name");
  return !text_at(file, "bearing.file").empty() || (!name.empty() && !is_builtin_name(name) && is_written_out(file));
}

Bearing base_bearing(const TomlFile &file, const std::string &folder) {
  const std::string name = text_at(file, "bearing.name"), path = text_at(file, "bearing.file");
  if (!path.empty()) {
    const std::string full = (fs::path(folder) / path).lexically_normal().string();
    try {
      return parse_bearing(read_named_file(full), full, models_stack(file));
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

Bearing load_bearing(const std::string &where) {
  if (is_builtin_name(where)) return builtin_bearing(where);
  std::error_code ignored;
  if (!fs::exists(where, ignored)) {
    refuse_isolator(where);
    throw InputError(
        fmt::format("{}: no such file, and bearing {}", where, unknown_word(where, builtin_bearing_names())));
  }
  return parse_bearing(read_named_file(where), where, false);
}

} // namespace rimpact::scene

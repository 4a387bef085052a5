/// Scenes from TOML: defaults that depend on other keys, files beside the scene, errors with their place.
#include "io/files/file.h"
#include "io/files/text.h"
#include "io/files/toml_reader.h"
#include "io/records/record_library.h"
#include "scene/adopted_calibration.h"
#include "scene/bearing_keys.h"
#include "scene/bearing_toml.h"
#include "scene/file_kind.h"
#include "scene/isolator_catalogue.h"
#include "scene/keys.h"
#include "scene/scene_catalogue.h"
#include "scene/scene_defaults.h"
#include "scene/scene_keys.h"
#include "scene/unread_keys.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

namespace fs = std::filesystem;

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
    name = find_record(name, folder);
    try {
      signal = *shared_record(name, scene.load.gravity);
    } catch (const InputError &error) {
      throw InputError(fmt::format("{}: {} {}", file.location(key), key, error.what()));
    } catch (const DataError &error) {
      std::error_code ignored;
      const std::string shelf = records_shelf(), nor = shelf.empty() || fs::exists(name, ignored)
                                                           ? ""
                                                           : fmt::format(" (nor is it in RIMPACT_RECORDS, {})", shelf);
      throw DataError(fmt::format("{}: {} {}{}", file.location(key), key, error.what(), nor));
    }
  };
  read("x", e.x_file, e.x);
  read("y", e.y_file, e.y);
  read("z", e.z_file, e.z);
}

/// Reads the path a scene names; afterwards its name is absolute.
void read_path(const TomlFile &file, Scene &scene, const std::string &folder) {
  auto &e = scene.excitation;
  if (e.kind != ExcitationKind::path || e.path_file.empty()) return;
  make_absolute(e.path_file, folder);
  try {
    e.path = read_path_table(e.path_file);
  } catch (const DataError &error) {
    throw DataError(fmt::format("{}: excitation.file {}", file.location("excitation.file"), error.what()));
  }
}

/// Reads the table of friction a scene names; afterwards its name is absolute.
void read_friction(const TomlFile &file, MeasuredFriction &measured, const std::string &folder) {
  if (measured.table_file.empty()) return;
  make_absolute(measured.table_file, folder);
  try {
    measured.table =
        std::make_shared<const friction::FrictionTable>(friction::read_friction_table(measured.table_file));
  } catch (const DataError &error) {
    throw DataError(fmt::format("{}: reduced.mu_table {}", file.location("reduced.mu_table"), error.what()));
  }
}

/// A setting of one half of a load whose other half the scene has: it stays.
std::string remark_on_half_a_load(const TomlFile &file, const std::vector<std::string> &overrides, const Load &load) {
  const auto is_set = [&](const std::string &key) {
    return std::any_of(overrides.begin(), overrides.end(),
                       [&](const auto &each) { return each.starts_with(key + "="); });
  };
  const bool weight = is_set("load.vertical_kN"), mass = is_set("load.mass_kg");
  const double ratio = load.vertical / (load.mass * load.gravity);
  constexpr double near = 0.01; // W = m g
  if (weight == mass || !file.find("load.vertical_kN") || !file.find("load.mass_kg") || std::abs(ratio - 1) < near)
    return {};
  return fmt::format("{} stays as {} has it, so that W = {:.3g} m g: set both of load.vertical_kN and load.mass_kg",
                     weight ? fmt::format("load.mass_kg = {:g}", load.mass)
                            : fmt::format("load.vertical_kN = {:g}", load.vertical / 1e3),
                     file.origin(), ratio);
}

/// The numbers that [isolator] begins with: those of the catalogue where it is named or the model needs one.
Isolator base_isolator(const TomlFile &file) {
  const std::string name = text_at(file, "isolator.name");
  try {
    if (!name.empty()) return builtin_isolator(name);
  } catch (const InputError &error) {
    throw InputError(fmt::format("{}: {}", file.location("isolator.name"), error.what()));
  }
  const bool triple = text_at(file, "reduced.model") == word(ModelKind::tfp);
  return triple ? builtin_isolator(default_triple) : Isolator();
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
  const auto typed = typed_element_keys(file, reduced_section),
             typed_inner = typed_element_keys(file, inner_rims_section);
  const TakenTerms taken = adopt_calibration(file, folder, scene.bearing, scene.remarks);
  adopt_inner_calibration(file, folder, scene.remarks);
  require_inner_element(file);
  scene.isolator = base_isolator(file);
  visit_settings(reader, scene);
  reader.finish();
  if (is_changed_by_hand(typed, scene.reduced, scene.remarks)) scene.reduced.forget_fit();
  if (auto &rims = scene.isolator.inner.rims; is_changed_by_hand(typed_inner, rims, scene.remarks))
    rims.forget_calibration();
  if (!taken.keys.empty()) leave_out_what_does_not_fit(scene);
  for (const auto &key : taken.keys) file.erase(key); // the scene's own keys are judged from here on
  // Geometry first: a bearing that cannot be built is said before a record that is missing.
  with_location(file, "bearing", [&] { check_bearing(scene); });
  read_records(file, scene, folder);
  read_path(file, scene, folder);
  read_friction(file, scene.reduced.measured, folder);
  if (!scene.reduced.impact_curve.empty()) make_absolute(scene.reduced.impact_curve, folder);
  if (scene.model.own_mesh.any()) make_absolute(scene.model.own_mesh.file, folder);
  set_dependent_defaults(file, has_own_bearing(file), scene);
  if (taken.bearings_slip) resolve_elastic_slip(scene);
  scene.isolator_remark = unread_keys(file, scene, UnreadPart::isolator);
  scene.springs_remark = unread_keys(file, scene, UnreadPart::springs);
  for (const auto &remark : {unread_keys(file, scene, UnreadPart::scene), scene.isolator_remark, scene.springs_remark})
    if (!remark.empty()) scene.remarks.push_back(remark);
  if (std::string remark = remark_on_half_a_load(file, overrides, scene.load); !remark.empty())
    scene.remarks.push_back(scene.load_remark = std::move(remark));
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

Scene load_scene(const std::string &where, const std::vector<std::string> &overrides) {
  if (const auto *entry = find_builtin_scene(where)) {
    try {
      return parse_scene(entry->text, where, overrides);
    } catch (const DataError &error) {
      const std::string what = error.what(); // of a file that was given: its own error, and no other is needed
      throw DataError(entry->needs.empty() || what.starts_with("--set ")
                          ? what
                          : fmt::format("{} ({})", entry->needs, error.what()));
    }
  }
  std::error_code ignored;
  fs::path path = where;
  if (fs::is_directory(path, ignored)) path /= "scene.toml";
  if (!fs::exists(path, ignored)) {
    refuse_isolator(where);
    throw InputError(
        fmt::format("{}: no such file, and scene {}", path.string(), unknown_word(where, builtin_scene_names())));
  }
  return parse_scene(read_named_file(path.string()), path.string(), overrides, path.parent_path().string());
}

} // namespace rimpact::scene

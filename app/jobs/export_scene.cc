#include "app/jobs/export_scene.h"

#include "calibration/export/comment.h"
#include "calibration/export/exported_model.h"
#include "io/files/error.h"
#include "scene/bearing_catalogue.h"
#include "scene/case_description.h"
#include "scene/rim_identity.h"
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

namespace fs = std::filesystem;
using calibration::ExportedRim;
using scene::StoredCalibration;

scene::Scene scene_or_bearing(const std::string &where) {
  scene::Scene scene;
  try {
    return scene::load_scene(where);
  } catch (const InputError &) {
    scene.bearing = scene::load_bearing(where); // its message stands where both fail
  }
  return scene;
}

/// The scene whose dish the bearing has: given, or of a fitted run, or a built-in bearing; of this rim by its identity.
std::optional<scene::Scene> scene_of(const ExportOptions &options, const StoredCalibration &calibration,
                                     const ExportedRim &rim) {
  if (!options.scene.empty()) {
    auto scene = scene_or_bearing(options.scene);
    if (scene::rim_identity(scene.bearing) != rim.rim_identity)
      throw InputError(fmt::format("--scene {}: {} ({}) is another bearing than {}, to whose rim the law was fitted",
                                   options.scene, scene.bearing.name, scene::rim_in_words(scene.bearing), rim.bearing));
    return scene;
  }
  std::vector<std::string> candidates;
  for (const auto &run : calibration.fitted_runs)
    for (const auto &path : {fs::path(run), fs::path(options.folder) / fs::path(run).filename(),
                             fs::path(options.folder) / ".." / fs::path(run).filename()})
      candidates.push_back((path / "scene.toml").string()); // also where runs and calibration were moved together
  candidates.push_back((fs::path(options.folder) / "fitted-scene.toml").string());
  candidates.push_back(rim.bearing);
  for (const auto &candidate : candidates) try {
      const bool file = candidate != rim.bearing;
      if (file && !fs::exists(candidate)) continue;
      scene::Scene scene;
      if (file)
        scene = scene::load_scene(candidate);
      else
        scene.bearing = scene::builtin_bearing(candidate);
      if (scene::rim_identity(scene.bearing) == rim.rim_identity) return scene;
    } catch (const Error &) { // a run that cannot be read any more says nothing of the bearing
    }
  return std::nullopt;
}

/// The files are for one load: that of a scene which is given for its dish is not taken unasked.
void warn_of_load(const ExportOptions &options, const scene::Scene &scene, const ExportedRim &rim, Console &console) {
  if (options.scene.empty() || options.load || options.mass) return;
  const double own = scene.load.vertical; // a bearing's file, and a scene that names no load, have the default one
  if (own == scene::Load{}.vertical || std::abs(own / rim.vertical - 1) < 1e-3) return;
  console.warn(fmt::format("{} carries {:.6g} kN, the calibration's bearing {:.6g} kN, for which the files are; --load "
                           "{:.6g} makes them for the scene's",
                           options.scene, own / 1e3, rim.vertical / 1e3, own / 1e3));
}

/// The bearing carries what the files are for, with the terms of pad and socket that the calibration has.
void take_answer(scene::Scene &scene, const scene::StoredAnswer &answer, ExportedRim &rim) {
  rim.statement.insert(
      rim.statement.begin() + 1,
      calibration::plain_text(fmt::format("Its dimensions: L_c = {:.4g} mm, {}.", 1e3 * scene.lateral_capacity(),
                                          scene::rim_in_words(scene.bearing))));
  scene.load.vertical = rim.vertical, scene.load.mass = rim.mass, scene.load.gravity = rim.gravity;
  calibration::take_stack(scene, answer);
  for (const auto &line : calibration::stack_effect(scene, rim)) rim.statement.push_back(calibration::plain_text(line));
  rim.tuned_to = std::max(rim.to, calibration::fastest_touch(scene, rim));
  if (rim.tuned_to > rim.to)
    rim.statement.push_back(
        fmt::format("DOUBT: pulses of the self-check bring the model to its rim at up to {:.3g} m/s, "
                    "beyond {:.3g} m/s. Springs and links are tuned to the law as far as that.",
                    rim.tuned_to, rim.to));
}

} // namespace

std::optional<ExportScene> export_scene(const ExportOptions &options, const StoredCalibration &calibration,
                                        ExportedRim &rim, Console &console) {
  auto scene = scene_of(options, calibration, rim);
  if (!scene) return {};
  warn_of_load(options, *scene, rim, console);
  constexpr double farthest = 0.2; // a fitted place of the rim is within millimetres
  if (const double own = scene->lateral_capacity(); std::abs(rim.lateral_capacity / own - 1) > farthest)
    throw DataError(fmt::format("{}: answer.law.element.lateral_capacity_m, {:g}, is not that of the bearing, {:g}",
                                calibration.file, rim.lateral_capacity, own));
  take_answer(*scene, *calibration.answer, rim);
  auto dish = calibration::dish_of(*scene, rim.lateral_capacity);
  if (!dish.pad_remark.empty() && (options.opensees || options.sap2000 || options.etabs))
    console.warn("vertical stiffness of the bearing:" + dish.pad_remark);
  return ExportScene{*scene, std::move(dish)};
}

} // namespace rimpact::app

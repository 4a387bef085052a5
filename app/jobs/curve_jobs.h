/// Rim curves (`rimpact curve --held`) as processes, side by side.
#pragma once
#include "app/console/console.h"
#include "reduced_models/bearings/rim_curve_file.h"
#include <optional>

namespace rimpact::app {

struct CurveJob {
  std::string name;
  scene::Scene scene; ///< its bearing is pushed, on its mesh, for its mass at its window's speed
  std::string folder; ///< DIR/curves/NAME
  double expected_seconds = 0;
  bool reused = false;
  std::string failure = {}; ///< the push's own sentence; empty: it is done, or not yet begun
};

/// From the time of the window of the same scene: a curve takes this share of it, measured over three rims.
double expected_seconds_of_curve(const scene::Scene &window);

/// The curve in the job's folder, where it is of this rim and mesh, stops this mass at this speed, and was made by this
/// program.
std::optional<reduced::RimCurveFile> kept_curve(const CurveJob &job);

/// Pushes what is not kept. A failing one does not lose the others. Logs and scenes go to DIR/logs. Throws an Error of
/// exit code 130 on Ctrl-C.
void run_curves(std::vector<CurveJob> &jobs, const std::string &folder, std::size_t at_once, Console &console);

} // namespace rimpact::app

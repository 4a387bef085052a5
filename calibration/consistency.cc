#include "calibration/measured_run.h"
#include "calibration/series.h"
#include "scene/error.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {

namespace {

/// Measured figures that should agree may differ by this factor before units are suspected.
constexpr double suspicious = 3;

bool disagree(double a, double b) {
  return a > suspicious * b || b > suspicious * a;
}

double root_mean_square(const std::vector<double> &values) {
  double sum = 0;
  for (const double v : values) sum += v * v;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

void check_travel(const StoredRun &run) {
  const double travel = run.summary.peak_displacement, L_c = run.scene.bearing.lateral_capacity();
  if (travel > suspicious * L_c)
    throw DataError(fmt::format("{}: the slider travels {:.4g} m where the rim stands at {:.4g} m; is the "
                                "displacement's unit right?",
                                run.folder, travel, L_c));
}

void check_velocity(const StoredRun &run) {
  const auto &r = run.response;
  const double stated = root_mean_square(r.series("velocity_x")),
               slope = root_mean_square(differentiate(r.series("time"), r.series("displacement_x")));
  if (disagree(stated, slope))
    throw DataError(
        fmt::format("{}: velocity_x and the slope of displacement_x differ by a factor of {:.3g}; are "
                    "the units of time, displacement and velocity right?",
                    run.folder, stated / slope));
}

/// Impulse of the rim's force over the change of momentum, both radial.
double impulse_ratio(const StoredRun &run, const ImpactWindow &w) {
  double impulse = 0;
  for (std::size_t i = 1; i < w.times.size(); ++i)
    impulse += 0.5 * (w.times[i] - w.times[i - 1]) * (w.force[i] + w.force[i - 1]);
  return impulse / (run.scene.load.mass * (w.impact.approach_speed + w.impact.rebound_speed));
}

} // namespace

void require_consistent(const StoredRun &run) {
  check_travel(run);
  check_velocity(run);
  for (const auto &w : run.impacts) {
    if (w.grazing) continue; // other forces change its momentum as much
    const double ratio = impulse_ratio(run, w);
    if (ratio <= 0)
      throw DataError(fmt::format("{}: at {:.4f} s the rim's force points outwards; is its sign right?",
                                  run.folder, w.impact.touch_time));
    if (disagree(ratio, 1))
      throw DataError(
          fmt::format("{}: at {:.4f} s the impulse of the rim's force is {:.3g} times the change of "
                      "momentum; are the units of force and displacement and the mass ({:g} kg) right?",
                      run.folder, w.impact.touch_time, ratio, run.scene.load.mass));
  }
}

} // namespace rimpact::calibration

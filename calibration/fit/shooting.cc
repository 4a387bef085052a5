#include "calibration/fit/shooting.h"
#include "calibration/data/pulse.h"
#include "calibration/data/series.h"
#include "laws/impact/catalogue.h"
#include "reduced_models/simulate.h"
#include "responses/open_impact.h"
#include <algorithm>

namespace rimpact::calibration {

namespace {

std::vector<double> radial(const Response &response, const std::string &name, const Eigen::Vector2d &direction,
                           double sign = 1) {
  const auto &x = response.series(name + "_x"), &y = response.series(name + "_y");
  std::vector<double> values(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) values[i] = sign * (x[i] * direction.x() + y[i] * direction.y());
  return values;
}

/// Looked for a late release this long after the window [s].
constexpr double patience = 0.5;

/// Whether the first pulse lasts to the end.
bool presses_on(const std::vector<double> &force) {
  const auto touch = std::find_if(force.begin(), force.end(), [](double f) { return f != 0; });
  return touch != force.end() && std::find(touch, force.end(), 0.0) == force.end();
}

} // namespace

Flight fly_from(const scene::Scene &scene, const ImpactWindow &window, const reduced::BearingState &start) {
  const double capacity = scene.reduced.impact_law->yields ? scene.bearing.lateral_capacity() : window.capacity;
  auto run = reduced::simulate_from(scene, start, window.end_time, capacity);
  if (presses_on(radial(run.response, "impact", window.direction))) // a late release
    run = reduced::simulate_from(scene, start, window.end_time + patience, capacity);
  const auto &impacts = run.summary.impacts;
  Flight flight{run.response.series("time"), radial(run.response, "displacement", window.direction),
                radial(run.response, "velocity", window.direction),
                radial(run.response, "impact", window.direction, -1), 0};
  flight.rebound_speed =
      impacts.empty() || is_open(impacts.front()) ? -flight.velocity.back() : impacts.front().rebound_speed;
  return flight;
}

Flight fly(const scene::Scene &scene, const ImpactWindow &window) {
  return fly_from(scene, window, window.start);
}

Shot shoot(const scene::Scene &scene, const ImpactWindow &window) {
  return shoot(scene, window, window.start);
}

Shot shoot(const scene::Scene &scene, const ImpactWindow &window, const reduced::BearingState &start) {
  const Flight flight = fly_from(scene, window, start);
  Shot shot;
  shot.displacement.reserve(window.times.size());
  shot.force.reserve(window.times.size());
  for (const double t : window.times) {
    shot.displacement.push_back(hermite_at(flight.times, flight.displacement, flight.velocity, t));
    shot.force.push_back(pulse_at(flight.times, flight.force, t));
  }
  shot.peak = smooth_peak(window.times, shot.force); // at the reference's samples, as its own
  shot.rebound_speed = flight.rebound_speed;
  return shot;
}

Response history_of(const StoredRun &run, const scene::Scene &scene) {
  auto [response, summary] = reduced::simulate(scene);
  if (!run.is_window() || run.impacts.empty() || !run.impacts.front().measurement || summary.impacts.empty())
    return response;
  const double later = run.impacts.front().impact.touch_time - summary.impacts.front().touch_time;
  for (double &t : response.series("time")) t += later;
  return response;
}

} // namespace rimpact::calibration

#include "calibration/shooting.h"
#include "calibration/series.h"

namespace rimpact::calibration {

namespace {

std::vector<double> radial(const scene::Response &response, const std::string &name,
                           const Eigen::Vector2d &direction, double sign = 1) {
  const auto &x = response.series(name + "_x"), &y = response.series(name + "_y");
  std::vector<double> values(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) values[i] = sign * (x[i] * direction.x() + y[i] * direction.y());
  return values;
}

} // namespace

Shot shoot(const scene::Scene &scene, const ImpactWindow &window) {
  const auto run = reduced::simulate_from(scene, window.start, window.end_time, window.capacity);
  const auto &times = run.response.series("time");
  const auto u = radial(run.response, "displacement", window.direction);
  const auto v = radial(run.response, "velocity", window.direction);
  const auto force = radial(run.response, "impact", window.direction, -1);
  Shot shot;
  shot.displacement.reserve(window.times.size());
  shot.force.reserve(window.times.size());
  for (const double t : window.times) {
    shot.displacement.push_back(hermite_at(times, u, v, t));
    shot.force.push_back(pulse_at(times, force, t));
  }
  shot.peak = smooth_peak(times, force);
  shot.end_speed = linear_at(times, v, window.end_time);
  return shot;
}

} // namespace rimpact::calibration

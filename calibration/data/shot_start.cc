#include "calibration/data/shot_start.h"
#include "calibration/data/window_cutter.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {

namespace {

/// Where the reduced rim begins: at L_c, or where a dented rim was touched, if that is surely beyond it.
void find_capacity(const StoredRun &run, const MeasuredRecord &record, const WindowOptions &options,
                   const Contact &contact, const FlightFit &fit, double t_ref, ShotStart &start) {
  const auto &times = run.response.series("time");
  const double L_c = run.scene.bearing.lateral_capacity();
  const Eigen::Vector2d touch = fit.u + (contact.touch_time - t_ref) * fit.v;
  const double late =
      std::abs(times[contact.first] - contact.touch_time) + times[contact.first] - times[contact.first - 1];
  start.touch_noise = record.sigma() * std::sqrt(fit.shape(0, 0)), start.touch_late = fit.v.norm() * late;
  const double error = std::hypot(start.touch_noise, start.touch_late);
  start.touch = touch.norm();
  start.dented = touch.norm() > L_c + dent_tolerance + noise_reach * error;
  const bool own =
      options.touch == TouchReference::own_touch || (options.touch == TouchReference::automatic && start.dented);
  start.capacity = own ? touch.norm() : L_c;
}

/// Of a window record that begins at touch: the scene states the speed.
std::optional<ShotStart> stated_start(const StoredRun &run, const MeasuredRecord &record, const WindowOptions &options,
                                      std::size_t index, std::string &reason) {
  const Contact &contact = record.contacts()[index];
  const auto &times = run.response.series("time");
  const Eigen::Vector2d u = planar(run.response, "displacement", 0);
  const double L_c = run.scene.bearing.lateral_capacity(), beyond = u.norm() - L_c, sigma = record.sigma();
  const double speed = run.scene.excitation.impact_speed(),
               a_sample = speed * (times[1] - times[0]); // touched since the sample before
  if (run.is_window() && contact.first <= 2 && beyond < a_sample + noise_reach * sigma) {
    const Eigen::Vector2d variance(sigma * sigma + a_sample * a_sample / 3,
                                   std::pow(options.stated_speed_error * speed, 2));
    return ShotStart{.sample = 0,
                     .flown = 1,
                     .u = std::min(u.norm(), L_c) * u.normalized(),
                     .v = speed * u.normalized(),
                     .covariance = variance.asDiagonal(),
                     .capacity = L_c,
                     .dented = false,
                     .touch = u.norm(),
                     .touch_noise = sigma,
                     .touch_late = a_sample};
  }
  reason = fmt::format("the record holds {:.2g} ms before this touch ({} samples are free of the rim's force there, {} "
                       "are needed; 10 ms "
                       "or more tell the speed well): let it begin earlier, or sample it faster",
                       1e3 * std::max(0.0, contact.touch_time - times.front()), record.flights(index).before.size(),
                       shortest_flight);
  return {};
}

} // namespace

std::optional<ShotStart> shot_start(const StoredRun &run, const MeasuredRecord &record, const WindowOptions &options,
                                    std::size_t index, std::string &reason) {
  const Span flight = record.flights(index).before;
  if (flight.size() < shortest_flight) return stated_start(run, record, options, index, reason);
  const auto &times = run.response.series("time");
  const double end = times[flight.last];
  auto fit = record.state(flight, end);
  ShotStart start{};
  find_capacity(run, record, options, record.contacts()[index], fit, end, start);
  const double error = record.sigma() * std::sqrt(record.inflation() * fit.shape(0, 0)),
               speed = fit.u.normalized().dot(fit.v);
  const auto travel = [&](std::size_t i) { return fit.u.norm() + speed * (times[i] - end) + 4 * error; };
  std::size_t sample = flight.last;
  while (sample > flight.first && travel(sample) > start.capacity - options.lead) --sample;
  if (travel(sample) > start.capacity + 8 * error) {
    reason = fmt::format("{:.3g} mm beyond the rim's place before it bears force; is the displacement's zero right? "
                         "(--fit ...,capacity_offset "
                         "looks for the rim)",
                         1e3 * (travel(sample) - start.capacity));
    return {};
  }
  fit = record.state(flight, times[sample]);
  start.sample = sample, start.flown = flight.last + 1;
  start.u = fit.u, start.v = fit.v;
  start.covariance = record.sigma() * record.sigma() * record.inflation() * fit.shape;
  return start;
}

} // namespace rimpact::calibration

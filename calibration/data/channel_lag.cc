#include "calibration/data/channel_lag.h"
#include <cmath>

namespace rimpact::calibration {
namespace {

/// Radial motion at one end of a flight.
struct Radial {
  double t, u, v, acceleration;
  Eigen::Matrix2d covariance; ///< of (u, v)
};

Radial at_the_end_of(const MeasuredRecord &record, const std::vector<double> &times, const Span &flight, bool last,
                     const Eigen::Vector2d &direction) {
  const double near = times[last ? flight.last : flight.first], far = times[last ? flight.first : flight.last];
  const FlightFit here = record.state(flight, near), there = record.state(flight, far);
  const double variance = record.sigma() * record.sigma() * record.inflation();
  return {near, here.u.dot(direction), here.v.dot(direction), (here.v - there.v).dot(direction) / (near - far),
          variance * here.shape};
}

/// The centre of the channel's impulse in time, and its standard error [s].
std::pair<double, double> centre_of_force(const MeasuredRecord &record, const std::vector<double> &times, double begin,
                                          double end) {
  const auto &push = record.force().push;
  double impulse = 0, moment = 0, spread = 0;
  for (std::size_t i = 1; i + 1 < times.size() && times[i] <= end; ++i) {
    if (times[i] < begin) continue;
    const double weight = 0.5 * (times[i + 1] - times[i - 1]);
    impulse += weight * push[i], moment += weight * push[i] * times[i];
    spread += std::pow(weight * (times[i] - 0.5 * (begin + end)), 2);
  }
  return {moment / impulse, record.force().sigma * std::sqrt(spread) / impulse};
}

} // namespace

std::optional<ChannelLag> channel_lag(const MeasuredRecord &record, const std::vector<double> &times,
                                      std::size_t contact, const Eigen::Vector2d &direction) {
  const Flights &flights = record.flights(contact);
  if (flights.before.size() < shortest_flight || flights.after.size() < shortest_flight) return {};
  const Radial before = at_the_end_of(record, times, flights.before, true, direction),
               after = at_the_end_of(record, times, flights.after, false, direction);
  const double T = after.t - before.t, a = 0.5 * (before.acceleration + after.acceleration),
               change = before.v + a * T - after.v;
  if (!(change > 0)) return {};
  const double back = (before.u + before.v * T + 0.5 * a * T * T - after.u) / change;
  const Eigen::Vector2d of_before(1 / change, (T - back) / change), of_after(-1 / change, back / change);
  const double by_travel =
      std::sqrt(of_before.dot(before.covariance * of_before) + of_after.dot(after.covariance * of_after));
  const double by_acceleration =
      0.5 * std::abs(before.acceleration - after.acceleration) * T * std::abs(0.5 * T - back) / change;
  const auto [centre, by_force] = centre_of_force(record, times, before.t, after.t);
  const double by_samples = 0.25 * (times[1] - times[0]); // a force that jumps, taken between two of them
  return ChannelLag{centre - (after.t - back),
                    noise_reach * std::hypot(by_travel, by_force) + by_acceleration + by_samples};
}

} // namespace rimpact::calibration

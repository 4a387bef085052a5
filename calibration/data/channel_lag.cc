#include "calibration/data/channel_lag.h"
#include "calibration/data/window_cutter.h"
#include <algorithm>
#include <cmath>

namespace rimpact::calibration {
namespace {

/// Radial motion at one end of a flight.
struct Radial {
  double t, u, v, unlike;     ///< unlike: how far its acceleration is from the model's [m/s^2]
  Eigen::Matrix2d covariance; ///< of (u, v)
};

class Clocks {
public:
  Clocks(const StoredRun &run, const MeasuredRecord &record, const Eigen::Vector2d &direction)
      : run_(run), record_(record), times_(run.response.series("time")), direction_(direction), model_(run.scene) {}

  std::optional<ChannelLag> of(const Flights &flights) const;

private:
  Radial end_of(const Span &flight, bool last) const;
  std::optional<double> acceleration(std::size_t sample) const;
  std::pair<double, double> centre_of_force(std::size_t first, std::size_t last) const;
  /// Of a sample in the trapezoidal rule from first to last [s].
  double weight_of(std::size_t i, std::size_t first, std::size_t last) const {
    return 0.5 * (times_[std::min(i + 1, last)] - times_[i > first ? i - 1 : first]);
  }

  const StoredRun &run_;
  const MeasuredRecord &record_;
  const std::vector<double> &times_;
  Eigen::Vector2d direction_;
  reduced::PhysicalModel model_;
};

Radial Clocks::end_of(const Span &flight, bool last) const {
  const double near = times_[last ? flight.last : flight.first], far = times_[last ? flight.first : flight.last];
  const FlightFit here = record_.state(flight, near), there = record_.state(flight, far);
  const double variance = record_.sigma() * record_.sigma() * record_.inflation();
  double model = 0;
  for (std::size_t i = flight.first; i <= flight.last; ++i)
    model += acceleration(i).value_or(0) / static_cast<double>(flight.size());
  const double found = (here.v - there.v).dot(direction_) / (near - far);
  return {near, here.u.dot(direction_), here.v.dot(direction_), std::abs(found - model), variance * here.shape};
}

/// Of all but the rim, radial, where the record is [m/s^2]. The rim's push along the dish's slope takes load off it, in
/// the share rho of what is left; none: it lifts the slider, whose height the record does not tell.
std::optional<double> Clocks::acceleration(std::size_t sample) const {
  const Eigen::Vector2d u = planar(run_.response, "displacement", sample),
                        v = planar(run_.response, "velocity", sample);
  const auto dish = model_.height(u.x(), u.y());
  const auto forces = model_.forces(on_the_dish(model_, times_[sample], u, v));
  const Eigen::Vector3d ground = model_.ground_acceleration(times_[sample]);
  const double own = (forces.pendular + forces.friction).head<2>().dot(direction_), mass = run_.scene.load.mass,
               load = run_.scene.load.vertical +
                      mass * (v.dot(dish.hessian * v) + ground.z() - dish.gradient.dot(ground.head<2>())),
               rho = own == 0 ? 1 : 1 - dish.gradient.dot(direction_) * record_.force().push[sample] / load;
  if (!(load > 0 && rho > 0)) return {};
  return rho * own / mass - ground.head<2>().dot(direction_);
}

/// The centre of the channel's impulse in time, and its standard error [s].
std::pair<double, double> Clocks::centre_of_force(std::size_t first, std::size_t last) const {
  const auto &push = record_.force().push;
  const double middle = 0.5 * (times_[first] + times_[last]);
  double impulse = 0, moment = 0, spread = 0;
  for (std::size_t i = first; i <= last; ++i) {
    const double weight = weight_of(i, first, last);
    impulse += weight * push[i], moment += weight * push[i] * times_[i];
    spread += std::pow(weight * (times_[i] - middle), 2);
  }
  return {moment / impulse, record_.force().sigma * std::sqrt(record_.force().inflation * spread) / impulse};
}

std::optional<ChannelLag> Clocks::of(const Flights &flights) const {
  const Radial before = end_of(flights.before, true), after = end_of(flights.after, false);
  const std::size_t first = flights.before.last, last = flights.after.first;
  const double T = after.t - before.t;
  double gained = 0, moved = 0, largest = 0; // by all but the rim [m/s], [m]
  for (std::size_t i = first; i <= last; ++i) {
    const auto a = acceleration(i);
    if (!a) return {};
    const double weight = weight_of(i, first, last);
    gained += weight * *a, moved += weight * (after.t - times_[i]) * *a;
    largest = std::max(largest, std::abs(*a));
  }
  const double change = before.v + gained - after.v;
  if (!(change > 0)) return {};
  const double back = (before.u + before.v * T + moved - after.u) / change;
  const Eigen::Vector2d of_before(1 / change, (T - back) / change), of_after(-1 / change, back / change);
  const double by_travel =
      std::sqrt(of_before.dot(before.covariance * of_before) + of_after.dot(after.covariance * of_after));
  const double off = std::max({acceleration_doubt(largest), before.unlike, after.unlike});
  const double by_acceleration = off * T * std::max(T / 12, std::abs(T / 2 - back)) / change;
  const auto [centre, by_force] = centre_of_force(first, last);
  const double by_samples = 0.25 * T / static_cast<double>(last - first); // a force that jumps, between two of them
  return ChannelLag{centre - (after.t - back),
                    noise_reach * std::hypot(by_travel, by_force) + by_acceleration + by_samples};
}

} // namespace

std::optional<ChannelLag> channel_lag(const StoredRun &run, const MeasuredRecord &record, std::size_t contact,
                                      const Eigen::Vector2d &direction) {
  const Flights &flights = record.flights(contact);
  if (flights.before.size() < shortest_flight || flights.after.size() < shortest_flight) return {};
  return Clocks(run, record, direction).of(flights);
}

} // namespace rimpact::calibration

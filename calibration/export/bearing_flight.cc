#include "calibration/export/bearing_flight.h"

#include <array>
#include <cmath>
#include <numbers>

namespace rimpact::calibration {
namespace {

/// Position, speed, and what friction and the hinge against the rise carry, over what they can.
struct Motion {
  double u = 0, v = 0, friction = 0, rise = 0;
};

class BearingFlight {
public:
  BearingFlight(const FlownBearing &bearing, const scene::GroundMotion &ground) : b_(bearing), ground_(ground) {}

  void step(double t, double h) {
    const double middle = now_.u + h / 2 * now_.v, v_middle = now_.v + h / 2 * acceleration(t, now_.u, now_.v);
    const double a = acceleration(t + h / 2, middle, v_middle), u = now_.u + h * v_middle;
    slide(u - now_.u);
    now_.u = u, now_.v += h * a;
    meet_rim();
  }
  /// On the dish's table, and not past it.
  bool on_dish() const { return std::abs(now_.u) < b_.dish->travel.back(); }
  Arrival arrival() const {
    Arrival all = arrival_;
    all.leaves = !on_dish();
    return all;
  }

private:
  double mu(double v) const {
    const Dish &d = *b_.dish;
    const double slow = rides() ? d.ride_slow : d.mu_slow, fast = rides() ? d.ride_fast : d.mu_fast;
    return d.is_coulomb() ? fast : fast - (fast - slow) * std::exp(-d.rate * std::abs(v));
  }
  bool rides() const { return b_.slider == Slider::rides; }
  /// Restoring force that is not the rider's [N], under the vertical load `now`.
  double restores(double r, double now) const {
    const Dish &d = *b_.dish;
    if (rides()) return b_.weight * d.left_at(r);
    return d.sphere ? now * r / d.radius : b_.weight * d.slope_at(r);
  }
  double acceleration(double t, double u, double v) const {
    const double r = std::abs(u), side = u < 0 ? -1 : 1;
    const Eigen::Vector3d ground = ground_.acceleration(t);
    const double now = std::max(0.0, b_.weight + b_.mass * ground.z());
    const double p = rides() ? b_.dish->rider.slope(u) : 0, bend = rides() ? b_.dish->rider.curvature(u) : 0;
    const double rises = rides() ? b_.dish->rises * std::abs(p) * now_.rise : 0;
    const double push = p + mu(v) * now_.friction;
    const double rest = side * restores(r, now) + b_.weight * rises + side * rim_force(side, r - b_.capacity, side * v);
    return (-(now + b_.mass * bend * v * v) * push - rest - b_.mass * ground.x()) / (b_.mass * (1 + p * push));
  }
  double rim_force(double side, double d, double rate) const {
    const auto &rim = rims_[side > 0];
    return rim && d > 0 ? rim->force(d, rate) : 0;
  }
  void slide(double by) {
    const auto loaded = [&](double share) { return std::clamp(share + by / b_.dish->elastic_slip, -1.0, 1.0); };
    now_.friction = loaded(now_.friction), now_.rise = loaded(now_.rise);
  }
  void meet_rim() {
    const double side = now_.u < 0 ? -1 : 1, d = std::abs(now_.u) - b_.capacity, rate = side * now_.v;
    arrival_.largest_travel = std::max(arrival_.largest_travel, std::abs(now_.u));
    auto &rim = rims_[side > 0];
    if (d <= 0) {
      if (!b_.keeps_dents) rim.reset();
      return;
    }
    if (!rim) rim = b_.rim(rate);
    if (arrival_.touch_speed == 0) arrival_.touch_speed = rate;
    rim->accept(d);
    arrival_.peak_force = std::max(arrival_.peak_force, rim->force(d, rate));
  }

  const FlownBearing &b_;
  const scene::GroundMotion &ground_;
  Motion now_;
  std::array<std::unique_ptr<RimContact>, 2> rims_; ///< left, right
  Arrival arrival_;
};

} // namespace

Arrival fly_bearing(const FlownBearing &bearing, const scene::GroundMotion &ground, double duration) {
  constexpr int steps_per_half_period = 1000;
  constexpr double largest_angle = 0.05; // of the mass on its sticking friction, a step [rad]
  const double rim = std::numbers::pi * std::sqrt(bearing.mass / bearing.stiffness) / steps_per_half_period;
  const double held = std::sqrt(bearing.mass * bearing.dish->elastic_slip / (bearing.weight * bearing.dish->mu_fast));
  const double h = std::min({5e-5, rim, largest_angle * held});
  BearingFlight flight(bearing, ground);
  for (double t = 0; t < duration && flight.on_dish(); t += h) flight.step(t, h);
  return flight.arrival();
}

} // namespace rimpact::calibration

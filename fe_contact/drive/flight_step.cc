#include "fe_contact/drive/flight_step.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::fe {

Eigen::Vector3d FlightStep::travel() const {
  return frame.displacement(system.top_of(now.u)) - frame.displacement(system.top_of(old.u));
}

double FlightStep::work(const Eigen::Vector3d &force_before, const Eigen::Vector3d &force_after) const {
  return 0.5 * (force_before + force_after).dot(travel());
}

StepEnergies FlightStep::energies(const ContactStepReport &report) const {
  StepEnergies result = energies_of(system, now, report, system.model().energy_share());
  result.external = work(before.ground, after.ground);
  result.gravity = -work(before.weight, after.weight);
  result.friction -= work(before.friction, after.friction);
  return result;
}

double FlightStep::displacement_error(double rho_inf, double dt) const {
  const auto scheme = GeneralizedAlpha::from(rho_inf);
  const double change = system.top_of(now.a).x() - system.top_of(old.a).x();
  return frame.rate_ratio() * std::abs(scheme.beta - 1.0 / 6) * dt * dt * std::abs(change);
}

std::optional<std::string> passes(const scene::Rim &rim, const Passage &p, double t) {
  constexpr double passing_share = 0.01; // of the approach speed, outwards at release: not a rebound
  constexpr double folded_over = 20;     // times its thickness beyond L_c the wall lies flat and is no wall any more
  constexpr double chatter_depth = 1e-4; // nearer to L_c than this the walls may only have parted for an instant [m]
  constexpr double least_share = 0.05;   // of the rim's thickness or height: a wall pushed less has not been passed
  const bool folded = p.depth > folded_over * rim.thickness;
  const bool let_go =
      p.let_go && p.outward_speed > passing_share * p.approach_speed && (!p.may_touch || p.depth >= chatter_depth);
  if (!folded && !let_go) return {};
  if (!folded && p.depth < least_share * std::min(rim.thickness, rim.height))
    return fmt::format(
        "the walls part at t = {:.5g} s, {:.3f} mm beyond L_c, while the slider moves outwards at {:.3g} m/s: "
        "the contact chatters. Nothing after the touch is a result for this impact of {:.3g} m/s; a finer "
        "mesh (--mesh) or another model.step_ms may run through",
        t, 1e3 * p.depth, p.outward_speed, p.approach_speed);
  return fmt::format(
      "{} at t = {:.5g} s, {:.2f} mm beyond L_c, while the slider moves outwards at {:.3g} m/s: it passes "
      "through or over the rim (height {:g} mm, thickness {:g} mm), which this model does not follow; "
      "nothing after the touch is a result for this impact of {:.3g} m/s",
      folded ? "the rim is folded over" : "the rim let go of the slider", t, 1e3 * p.depth, p.outward_speed,
      1e3 * rim.height, 1e3 * rim.thickness, p.approach_speed);
}

} // namespace rimpact::fe

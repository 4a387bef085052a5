/// The impact element of a rim, as a file or a calibration gives it: its law, the law's numbers, and what they are
/// known for. SI units.
#pragma once
#include "laws/impact/catalogue.h"
#include <cmath>
#include <optional>
#include <string>

namespace rimpact::scene {

/// The tables of a scene file that have one: of the rims, and of a triple pendulum's inner rims where these have
/// theirs.
inline const std::string reduced_section = "reduced", inner_rims_section = "isolator.inner.rims";
/// Key by which these have theirs.
inline const std::string own_rims_key = "isolator.inner.own_rims";

struct ImpactElement : laws::LawNumbers {
  const laws::ImpactLaw *impact_law = &laws::default_law(); ///< its numbers are those of LawNumbers
  std::string calibration =
      {}; ///< folder the law and its numbers were taken from (key taken_from); empty: the scene's own keys
  std::optional<double> fitted_from = {},
                        fitted_to = {}; ///< approach speeds for which the element holds [m/s]; none: not known
  std::optional<double> fitted_mass =
      {}; ///< supported mass it holds for [kg]; none: the law belongs to the rim, not to the mass
  std::optional<double> fitted_speeds_mass =
      {}; ///< of the rim's own law: supported mass of fitted_from and fitted_to [kg]; at another they move as 1/sqrt(m)
  /// Of the rim [N], > 0: where the joint at its foot goes, and the law ends; none: no run it was fitted to went so
  /// far.
  std::optional<double> foot_force = {};
  std::string foot_joint = {}; ///< strength_in_words() of that joint; empty: one piece with the plate, or not known

  /// By which fitted_from and fitted_to move at a supported mass [kg]: a rim's own law is fitted to depths.
  double fitted_speed_scale(double mass) const {
    return fitted_speeds_mass ? std::sqrt(*fitted_speeds_mass / mass) : 1.0;
  }
  /// The element is of no calibration.
  void forget_calibration() {
    calibration.clear();
    fitted_from.reset(), fitted_to.reset(), fitted_mass.reset(), fitted_speeds_mass.reset();
    forget_foot();
  }
  /// It is integrated, or fitted, beyond the joint at the rim's foot.
  void forget_foot() { foot_force.reset(), foot_joint.clear(); }
  /// Of the rim, for a supported mass [kg]. Throws as laws::rim_element.
  laws::RimElement element(double supported_mass) const {
    return laws::rim_element(*impact_law, *this, supported_mass);
  }
  bool operator==(const ImpactElement &) const = default;
};

} // namespace rimpact::scene

/// By which factor a measured force differs from the one that moves the mass as the displacement says.
#pragma once
#include "calibration/data/impact_window.h"
#include <optional>

namespace rimpact::calibration {

struct ForceFactor {
  double value; ///< 1: force, displacement, clock and mass agree; < 0: the force is of the wrong sign
  double error; ///< standard error, by what is not known of the approach speed
};

/// From the contact alone, without the flight after it: of u(t) = u_0 + v_0 t - factor x double integral of F / m over
/// the samples from the start of the shot to the release, the factor by least squares. None where no force acts there.
/// Other forces than the rim's are left out: of an impact that is not isolated the factor tells orders only.
std::optional<ForceFactor> force_factor(const ImpactWindow &window, double mass);

} // namespace rimpact::calibration

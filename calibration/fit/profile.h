/// Profile likelihood: how fast the fit worsens when one parameter is held away from its best value.
#pragma once
#include "calibration/fit/fit.h"

namespace rimpact::calibration {

struct Profile {
  std::vector<double> values; ///< of the parameter, reported unit, growing
  std::vector<double> costs;  ///< half the sum of squares above the best, others refitted [-]
  /// Ends of the 95 % interval by stated uncertainties: where the cost, scaled to a likelihood, has risen
  /// enough; by interpolation. Empty: not within the values.
  std::optional<double> low, high;
};

/// `n` values on each side of the best, out to twice the stated 95 % interval.
/// Throws InputError when `name` is not fitted or stands alone.
Profile profile_of(const std::vector<const StoredRun *> &runs, const FitOptions &options, const FitResult &best,
                   const std::string &name, int n = 5);

} // namespace rimpact::calibration

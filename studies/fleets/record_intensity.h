/// How strong a ground motion is.
#pragma once
#include <string>
#include <vector>

namespace rimpact::fleets {

/// Of a motion before any scale: the largest of its horizontal components'.
struct Intensity {
  double pga_g; ///< peak acceleration [standard g]
  double pgv;   ///< peak velocity [m/s]
  double sa_g;  ///< spectral acceleration at sa_period with 5 % damping [standard g], 0 when none is asked for
};
/// `sa_period` [s]; 0: none. Throws DataError naming a file that cannot be read.
Intensity intensity(const std::vector<std::string> &horizontal, double sa_period = 0);

} // namespace rimpact::fleets

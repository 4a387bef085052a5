/// The levels of thesis 2.6.6 and a lognormal fragility over them.
#pragma once
#include <cmath>
#include <vector>

namespace ten_levels {

/// S_a(3 s) [g].
inline const std::vector<double> all{0.015, 0.0465, 0.0811, 0.1129, 0.166, 0.2086, 0.2623, 0.3145, 0.3965, 0.4362};

/// P at an intensity, of a lognormal of `median` and deviation `beta`.
inline double lognormal(double x, double median, double beta) {
  return std::erfc(-std::log(x / median) / beta / std::sqrt(2.0)) / 2;
}

} // namespace ten_levels

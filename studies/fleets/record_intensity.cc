#include "studies/fleets/record_intensity.h"
#include "io/records/record_library.h"
#include "io/records/spectral_acceleration.h"
#include <algorithm>

namespace rimpact::fleets {

Intensity intensity(const std::vector<std::string> &horizontal, double sa_period) {
  Intensity largest{0, 0, 0};
  for (const auto &path : horizontal) {
    const auto record = shared_record(path);
    const auto info = inspect(*record);
    const double sa = sa_period > 0 ? spectral_acceleration(*record, sa_period) / standard_gravity : 0.0;
    largest = {std::max(largest.pga_g, info.pga_g), std::max(largest.pgv, info.pgv), std::max(largest.sa_g, sa)};
  }
  return largest;
}

} // namespace rimpact::fleets

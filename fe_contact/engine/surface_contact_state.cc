#include "fe_contact/engine/surface_contact_state.h"

#include <algorithm>
#include <limits>

namespace rimpact::fe {

using Eigen::Vector3d;

SurfaceContactState SurfaceContactState::of(std::size_t n) {
  return {std::vector<double>(n, 0.0),
          std::vector<Vector3d>(n, Vector3d::Zero()),
          {},
          std::vector<double>(n, std::numeric_limits<double>::infinity()),
          std::vector<double>(n, 0.0),
          std::vector<Vector3d>(n, Vector3d::Zero()),
          std::vector<Vector3d>(n, Vector3d::Zero()),
          std::vector<ContactStatus>(n, ContactStatus::open),
          std::vector<char>(n, 1), // what overlaps from the start bears
          std::vector<int>(n, -1),
          std::vector<double>(n, 0.0)};
}

void SurfaceContactState::note_change(const std::vector<double> &pressures_before) {
  change = pressure;
  for (std::size_t k = 0; k < pressures_before.size(); ++k) change[k] -= pressures_before[k];
}

void SurfaceContactState::expect(double times) {
  for (std::size_t k = 0; k < change.size(); ++k)
    if (multiplier[k] > 0) multiplier[k] = std::max(0.0, multiplier[k] + times * change[k]);
}

} // namespace rimpact::fe

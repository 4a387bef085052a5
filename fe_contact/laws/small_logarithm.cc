#include "fe_contact/laws/small_logarithm.h"

#include <cmath>

namespace rimpact::fe {

std::optional<Eigen::Matrix3d> small_logarithm(const Eigen::Matrix3d &b) {
  constexpr double largest = 0.05, last_digit = -38; // ln of a third of the rounding of numbers
  const Eigen::Matrix3d x = b - Eigen::Matrix3d::Identity();
  const double size = x.norm();
  if (!(size < largest)) return {};
  const int terms = size > 0 ? static_cast<int>(std::ceil(last_digit / std::log(size))) : 1;
  Eigen::Matrix3d sum = x / terms;
  for (int k = terms - 1; k > 0; --k) sum = (x / k - x.lazyProduct(sum)).eval();
  return sum;
}

} // namespace rimpact::fe

/// Logarithm of a symmetric tensor near unity, without its principal axes.
#pragma once
#include <Eigen/Core>
#include <optional>

namespace rimpact::fe {

/// By the series of ln(1 + X), to the last digit. Empty where |X| > 0.05: there the eigenvalues cost less.
std::optional<Eigen::Matrix3d> small_logarithm(const Eigen::Matrix3d &b);

} // namespace rimpact::fe

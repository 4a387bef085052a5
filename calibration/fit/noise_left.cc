#include "calibration/fit/noise_left.h"
#include <cmath>
#include <Eigen/LU>

namespace rimpact::calibration {

namespace {

/// Of a normal variable; what it exceeds once in thirty thousand.
constexpr double improbable = 4;

/// By Wilson and Hilferty: the value of a chi-squared variable over its mean, at so many degrees of freedom.
double improbable_share(double freedom) {
  const double small = 2 / (9 * freedom);
  return std::pow(std::max(1.0, 1 - small + improbable * std::sqrt(small)), 3);
}

NoiseLeft of_group(const Group &group, const Eigen::MatrixXd &followed, const Eigen::MatrixXd &K) {
  const Eigen::MatrixXd U = followed.middleRows(group.first, group.count), M = K * (U.transpose() * U);
  const double n = group.count, sum = group.noise * n + M.trace(),
               squares = group.noise * group.noise * n + 2 * group.noise * M.trace() + (M * M).trace();
  if (!(sum > 0 && squares > 0)) return {0, 0};
  const double freedom = 1 / (squares / (sum * sum) + 1 / group.freedom);
  return {sum / n, sum / n * improbable_share(freedom)};
}

} // namespace

std::vector<NoiseLeft> noise_left(const Linearised &part, const Eigen::MatrixXd &inverse,
                                  const Eigen::MatrixXd &covariance) {
  const auto m = part.J.rows(), n_own = part.own.cols(), n = part.J.cols(), q = n_own + n;
  Eigen::MatrixXd Q(m, q), B(m, q);
  Q << part.own, part.J;
  B.rightCols(n) = part.weight * part.J * inverse;
  if (n_own > 0) B.leftCols(n_own) = part.own * (part.own.transpose() * part.own).inverse();
  const Eigen::MatrixXd Y =
      part.block->noise_times(B, Channel::force) + part.block->noise_times(B, Channel::displacement);
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(2 * q, 2 * q), followed(m, 2 * q);
  K.topLeftCorner(q, q) = B.transpose() * Y;
  K.block(n_own, n_own, n, n) = covariance;
  K.topRightCorner(q, q).diagonal().setConstant(-1), K.bottomLeftCorner(q, q).diagonal().setConstant(-1);
  followed << Q, Y;
  std::vector<NoiseLeft> left;
  for (const Group &group : part.block->groups()) left.push_back(of_group(group, followed, K));
  return left;
}

} // namespace rimpact::calibration

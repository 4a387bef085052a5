/// What the shape of the sum of squares says of the fitted values: covariance, correlation, condition.
#pragma once
#include "calibration/problem.h"

namespace rimpact::calibration {

struct Spread {
  Eigen::MatrixXd
      stated_covariance;      ///< the same from the stated uncertainties alone: what the data could tell
  Eigen::MatrixXd covariance; ///< of the fitted variables
  double condition = 0; ///< of the Jacobian in relative changes; infinite when a parameter has no effect
};
/// At the solution x; `robust_scale` as in FitOptions. Throws std::logic_error when x cannot be evaluated.
Spread spread_at(const Problem &problem, const Eigen::VectorXd &x, double robust_scale);

/// Fills parameters, correlation and condition of `result` from a solution; decides what is identifiable.
void judge(const Problem &problem, const Eigen::VectorXd &x, const Spread &spread, FitResult &result);

} // namespace rimpact::calibration

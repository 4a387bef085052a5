/// What the shape of the sum of squares says of the fitted values: covariance, correlation, condition.
#pragma once
#include "calibration/fit/problem.h"

namespace rimpact::calibration {

struct Spread {
  Eigen::MatrixXd stated_covariance; ///< the same from the stated uncertainties alone: what the data could tell
  Eigen::MatrixXd covariance;        ///< of the fitted variables
  Eigen::VectorXd freedom;           ///< degrees of freedom of each one's variance, by Welch and Satterthwaite
  bool within_noise = true;          ///< no group of a measured impact leaves more than its noise
  bool measured = false;             ///< any impact is
  double condition = 0;              ///< of the Jacobian in relative changes; infinite when a parameter has no effect
};
/// The blocks' own unknowns, one vector a block.
using Nuisance = std::vector<Eigen::VectorXd>;

/// At the solution; `robust_scale` as in FitOptions. What the blocks' own unknowns can follow is projected out of their
/// Jacobians, so their errors are in the covariance. Throws std::logic_error when the solution cannot be evaluated.
Spread spread_at(const Problem &problem, const Eigen::VectorXd &x, const Nuisance &nuisance, double robust_scale);

/// Fills parameters, correlation and condition of `result` from a solution; decides what is identifiable.
void judge(const Problem &problem, const Eigen::VectorXd &x, const Spread &spread, FitResult &result);

} // namespace rimpact::calibration

/// What the shape of the sum of squares says of the fitted values: covariance, correlation, condition.
#pragma once
#include "calibration/fit/problem.h"

namespace rimpact::calibration {

/// Of all unknowns (Problem). One that ended at a bound is held there: the others are judged as if it were given, and
/// its own variance is that of a fit which lets it go; infinite where that tells nothing.
struct Covariance {
  std::vector<bool> free;            ///< not held at a bound
  Eigen::MatrixXd stated_covariance; ///< the same from the stated uncertainties alone: what the data could tell
  Eigen::MatrixXd covariance;        ///< of the fitted variables
  Eigen::VectorXd freedom;           ///< degrees of freedom of each one's variance, by Welch and Satterthwaite
  bool within_noise = true;          ///< no group of a measured impact leaves more than its noise
  bool measured = false;             ///< any impact is
  double condition = 0; ///< of the free ones' Jacobian in relative changes; infinite when one has no effect
};
/// The blocks' own unknowns, one vector a block.
using Nuisance = std::vector<Eigen::VectorXd>;

/// At the solution; `robust_scale` as in FitOptions. What the blocks' own unknowns can follow is projected out of their
/// Jacobians, so their errors are in the covariance. Throws std::logic_error when the solution cannot be evaluated.
Covariance covariance_at(const Problem &problem, const Eigen::VectorXd &x, const Nuisance &nuisance,
                         double robust_scale);

} // namespace rimpact::calibration

/// One search of a fit from one start, by Ceres' trust region within the bounds.
#pragma once
#include "calibration/fit/uncertainty.h"

namespace rimpact::calibration {

/// Where a search ended.
struct Ending {
  Eigen::VectorXd x; ///< Problem::n_unknowns() of them
  Nuisance nuisance;
  double cost; ///< half the sum of squares
  bool usable, converged;
  std::string message;
};

/// Unknowns at one of their bounds.
std::vector<int> held_at_bounds(const Problem &problem, const Eigen::VectorXd &x);
/// `best`: the cost of the best search before; one that creeps far above it is given up.
Ending search(const Problem &problem, Eigen::VectorXd x, const FitOptions &options, double best);

} // namespace rimpact::calibration

/// What the noise of records leaves in the residuals of a fit, to tell a law's form from noise.
///
/// Near the solution the residuals of a block are eps - N c - J d: eps their own noise with covariance V, N c what the
/// block's own unknowns follow of it, J d what the parameters follow of the noise of all blocks. So a channel without
/// noise of its own is not met exactly where another one has noise, and a channel fitted closely keeps less than its
/// noise. The covariance of a group's residuals, V - Y Q^T - Q Y^T + Q C Q^T with Q = [N J], gives their mean square
/// and, by its trace and that of its square, the degrees of freedom it spreads with.
#pragma once
#include "calibration/fit/residuals.h"

namespace rimpact::calibration {

/// A block at the solution, linear in what is fitted.
struct Linearised {
  const ResidualBlock *block;
  Eigen::VectorXd r;   ///< residuals
  Eigen::MatrixXd J;   ///< by the parameters, less what the block's own unknowns can follow
  Eigen::MatrixXd own; ///< by these unknowns; no columns where there are none
  double weight;       ///< of the block, by the robust loss
};

struct NoiseLeft {
  double mean;  ///< mean square of a group's residuals that noise leaves
  double limit; ///< what noise exceeds once in thirty thousand groups, >= mean
};

/// Of each group of a measured block. `inverse` is A^-1 of the fit's normal matrix A, `covariance` that of the
/// parameters by noise alone.
std::vector<NoiseLeft> noise_left(const Linearised &part, const Eigen::MatrixXd &inverse,
                                  const Eigen::MatrixXd &covariance);

} // namespace rimpact::calibration

/// Hysteretic spring of Bouc and Wen in its rotation-invariant biaxial form (Park, Wen, Ang 1986), A = 1:
///   u_y z' = d' - |z|^(n-2) z (beta |z . d'| + (1 - beta) z . d'),      f = r k d + (1 - r) k u_y z.
/// In one direction it is z' = d'/u_y (A - (beta sign(z d') + gamma) |z|^n), gamma = 1 - beta: thesis (2-26),
/// (2-27) and (4-5), with d' / u_y where (2-27) prints u_y d', which has not the unit of z'. A and the scale
/// of z are one parameter too many (Ma et al. 2004), so |z| <= 1 and the yield force is k u_y.
#pragma once
#include <Eigen/Core>

namespace rimpact::reduced {

struct BoucWen {
  double yield = 0.02;      ///< u_y [m], > 0
  double exponent = 2;      ///< n [-], >= 1: sharpness of the knee
  double beta = 0.5;        ///< [-], 0.5..1: unloads with the elastic stiffness at 0.5, loses energy within loops above
  double post_yield = 0.05; ///< r [-], < 1; negative: softening

  struct Rate {
    Eigen::Vector2d rate;        ///< z' [1/s]
    Eigen::Matrix2d d_z, d_rate; ///< its derivatives by z and d'
  };
  Eigen::Vector2d rate(const Eigen::Vector2d &z, const Eigen::Vector2d &drift_rate) const;
  Rate rate_and_slopes(const Eigen::Vector2d &z, const Eigen::Vector2d &drift_rate) const;

  /// Implicit stage z = z0 + h z'(z, d') and its derivative by d'. |z0| <= 1, h > 0.
  struct Step {
    Eigen::Vector2d z;
    Eigen::Matrix2d d_rate;
  };
  Step implicit_step(const Eigen::Vector2d &z0, const Eigen::Vector2d &drift_rate, double h) const;

  /// Drift at which a softening storey has no strength left, (1 - r) u_y / -r [m] (thesis Fig. 4-3c);
  /// infinite for r >= 0.
  double collapse_drift() const;
};

} // namespace rimpact::reduced

/// Implicit stage of a hysteretic state of Bouc and Wen with sharpness n = 2, in any number of directions:
///   q z' = v - c (z . v) z,    c = `loading` where z . v > 0, `unloading` elsewhere.
/// Park and Wen's friction state has c = 1 and 0, a storey's 1 and 1 - 2 beta <= 0.
#pragma once
#include <cmath>
#include <Eigen/Core>

namespace rimpact::reduced {

template <int dim> struct WenStage {
  Eigen::Matrix<double, dim, 1> z;            ///< at the stage's end
  Eigen::Matrix<double, dim, dim> d_velocity; ///< its derivative by v [s/m]
};

/// z = w - (h/q) c (z . v) z, w = z0 + (h/q) v, in closed form: t = z . v is the root of (h/q) c t^2 + t = w . v of
/// the sign of w . v. `loading` >= 0 >= `unloading`, so that there is one.
template <int dim>
WenStage<dim> wen_stage(const Eigen::Matrix<double, dim, 1> &z0, const Eigen::Matrix<double, dim, 1> &v,
                        double h_over_q, double loading, double unloading) {
  const Eigen::Matrix<double, dim, 1> w = z0 + h_over_q * v;
  const double drive = w.dot(v), gain = h_over_q * (drive > 0 ? loading : unloading);
  const double root = std::sqrt(1 + 4 * gain * drive), share = 2 / (1 + root); // 1 / (1 + gain t)
  // d share/d drive = -4 gain / (root (1 + root)^2)
  const double slope = -gain * share * share / root;
  WenStage<dim> stage{share * w, slope * w * (w + h_over_q * v).transpose()};
  stage.d_velocity.diagonal().array() += share * h_over_q;
  return stage;
}

} // namespace rimpact::reduced

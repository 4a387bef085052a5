/// The member of the generalised-alpha family that takes every force at t_{n+1} (alpha_f = 0; Wood, Bossak
/// and Zienkiewicz 1980), so that contact is implicit at the end of the step. rho_inf is the spectral radius
/// at infinite frequency: 1 is the trapezoidal rule, 0 kills what the step cannot resolve.
///   M [(1 - alpha_m) a_{n+1} + alpha_m a_n] = R_{n+1},
///   u_{n+1} = u_n + dt v_n + dt^2 [(1/2 - beta) a_n + beta a_{n+1}],  v_{n+1} = v_n + dt [(1 - gamma) a_n +
///   gamma a_{n+1}].
#pragma once
#include <Eigen/Core>

namespace rimpact::fe {

struct GeneralizedAlpha {
  double alpha_m, beta, gamma;

  /// 0 <= rho_inf <= 1; second-order accurate, unconditionally stable in linear problems (Chung and Hulbert
  /// 1993).
  static GeneralizedAlpha from(double rho_inf) {
    const double alpha_m = (rho_inf - 1) / (rho_inf + 1);
    return {alpha_m, 0.25 * (1 - alpha_m) * (1 - alpha_m), 0.5 - alpha_m};
  }
  Eigen::VectorXd predicted_displacement(const Eigen::VectorXd &u, const Eigen::VectorXd &v, const Eigen::VectorXd &a,
                                         double dt) const {
    return u + dt * v + dt * dt * (0.5 - beta) * a;
  }
  Eigen::VectorXd predicted_velocity(const Eigen::VectorXd &v, const Eigen::VectorXd &a, double dt) const {
    return v + dt * (1 - gamma) * a;
  }

  /// Energy the integrator takes out of a step [J], from its own formula: with du, da, dR the changes over
  /// the step and M da given, the kinetic energy changes by the trapezoidal work of R less exactly this
  /// amount.
  double loss(double dt, const Eigen::VectorXd &du, const Eigen::VectorXd &da, const Eigen::VectorXd &mass_da,
              const Eigen::VectorXd &R_old, const Eigen::VectorXd &R_new) const {
    const double c = gamma - 1 + alpha_m;
    return -c * du.dot(mass_da) + dt * dt * (beta - 0.5 * gamma) * (da.dot(R_new) + c * da.dot(mass_da)) -
           0.5 * du.dot(R_new - R_old);
  }
};

} // namespace rimpact::fe

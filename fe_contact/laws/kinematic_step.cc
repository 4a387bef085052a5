#include "fe_contact/laws/kinematic_step.h"

#include "fe_contact/laws/kinematic_return.h"
#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <numbers>

namespace rimpact::fe {
namespace {

using std::numbers::sqrt2;

/// The symmetric function f of a symmetric tensor.
template <class Function> Matrix3 function_of(const Matrix3 &symmetric, const Function &f) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> spectrum(symmetric);
  const Eigen::Vector3d values = spectrum.eigenvalues().unaryExpr(f);
  return spectrum.eigenvectors() * values.asDiagonal() * spectrum.eigenvectors().transpose();
}
Matrix3 root(const Matrix3 &symmetric) {
  return function_of(symmetric, [](double x) { return std::sqrt(x); });
}

Tensor6 to_tensor(const Matrix3 &m) {
  Tensor6 t = to_vector(m);
  t.tail<3>() *= sqrt2;
  return t;
}
Matrix3 from_tensor(const Tensor6 &t) {
  Vector6 v = t;
  v.tail<3>() /= sqrt2;
  return to_matrix(v);
}

/// Trial state: principal axes of the elastic strain, in the intermediate and in the present configuration.
struct Trial {
  Eigen::Vector3d log_stretch; ///< ln of the principal stretches of F_e
  Matrix3 inner, outer;        ///< axes by columns; outer = R inner
};

/// The tangent in the outer axes, Voigt form with engineering shears. With l = d + w the velocity gradient, the strain
/// there grows by m_ij d_ij and R turns by w + kappa d, m = x / sinh x, kappa = -tanh(x / 2), x = ln(lambda_i /
/// lambda_j).
Matrix6 tangent_in_axes(const Trial &trial, const Tensor6 &stress, const Map6 &moduli) {
  const Matrix3 tau = from_tensor(stress);
  Matrix6 c;
  for (int v = 0; v < 6; ++v) {
    Matrix3 d = to_matrix(Vector6::Unit(v)), strain, turned;
    if (v >= 3) d *= 0.5;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const double x = trial.log_stretch[i] - trial.log_stretch[j];
        strain(i, j) = d(i, j) * (std::abs(x) > 1e-8 ? x / std::sinh(x) : 1);
        turned(i, j) = -d(i, j) * (std::tanh(x / 2) + 1);
      }
    const Matrix3 moved = turned * tau;
    c.col(v) = to_vector(from_tensor(moduli * to_tensor(strain)) + moved + moved.transpose());
  }
  return c;
}

/// Stresses in axes (columns) to those of the frame, in Voigt form.
Matrix6 turn_of_stress(const Matrix3 &axes) {
  Matrix6 turn;
  for (int v = 0; v < 6; ++v) turn.col(v) = to_vector(axes * to_matrix(Vector6::Unit(v)) * axes.transpose());
  return turn;
}

/// The state after a flow.
void advance(J2State &state, const KinematicReturn &returned, const Trial &trial, const Matrix3 &F) {
  const Matrix3 strain = trial.outer * from_tensor(returned.strain) * trial.outer.transpose() +
                         trial.log_stretch.mean() * Matrix3::Identity();
  const Matrix3 inverse = F.inverse(), b_elastic = function_of(strain, [](double x) { return std::exp(2 * x); });
  const Matrix3 cp_inverse = inverse * b_elastic * inverse.transpose();
  const Matrix3 Fp =
      trial.inner * trial.outer.transpose() * function_of(strain, [](double x) { return std::exp(-x); }) * F;
  const Matrix3 spin = Fp * root(cp_inverse); // F_p U_p^-1
  state.cp_inverse = to_vector(cp_inverse);
  for (std::size_t k = 0; k < returned.back.size(); ++k)
    state.backstress[k] =
        to_tensor(spin.transpose() * trial.inner * from_tensor(returned.back[k]) * trial.inner.transpose() * spin);
}

} // namespace

IsochoricResult kinematic_step(const HenckyJ2 &law, const J2State &old, const Matrix3 &F, double dt,
                               bool with_tangent) {
  IsochoricResult result;
  const Matrix3 Fe = old.alpha > 0 ? Matrix3(F * root(to_matrix(old.cp_inverse))) : F;
  const Eigen::SelfAdjointEigenSolver<Matrix3> spectrum(Fe.transpose() * Fe);
  if (!(spectrum.eigenvalues().minCoeff() > 0)) {
    result.admissible = false;
    return result;
  }
  Trial trial{0.5 * spectrum.eigenvalues().array().log(), spectrum.eigenvectors(), {}};
  const Eigen::Vector3d shrink = (-trial.log_stretch).array().exp();
  trial.outer = Fe * trial.inner * shrink.asDiagonal();
  const Eigen::Vector3d deviator = trial.log_stretch.array() - trial.log_stretch.mean();
  Backstress back;
  for (std::size_t k = 0; k < back.size(); ++k)
    back[k] = to_tensor(trial.inner.transpose() * from_tensor(old.backstress[k]) * trial.inner);
  const KinematicReturn returned = kinematic_return(law, to_tensor(deviator.asDiagonal()), back, old, dt);
  const Tensor6 stress = 2 * law.shear_modulus * returned.strain;
  const Matrix6 turn = turn_of_stress(trial.outer);
  result.energy = law.shear_modulus * returned.strain.squaredNorm();
  result.response.stress = to_vector(trial.outer * from_tensor(stress) * trial.outer.transpose());
  if (with_tangent) result.response.tangent = turn * tangent_in_axes(trial, stress, returned.moduli) * turn.transpose();
  result.state = old;
  result.state.overstress = returned.overstress;
  if (!(returned.flow > 0)) return result;
  const double radius = std::sqrt(1.5) * (stress - returned.back[0] - returned.back[1]).norm();
  result.mises = std::max(std::sqrt(1.5) * stress.norm(), radius);
  advance(result.state, returned, trial, F);
  result.state.alpha += returned.flow;
  result.state.lode += lode_parameter(from_tensor(stress).determinant(), result.mises) * returned.flow;
  result.state.viscous_work += 0.5 * (old.overstress + returned.overstress) * returned.flow;
  result.state.back_work += returned.back_work;
  return result;
}

} // namespace rimpact::fe

#include "fe_contact/laws/hencky_j2.h"
#include "fe_contact/laws/kinematic_step.h"
#include "fe_contact/laws/plastic_flow.h"
#include "fe_contact/laws/small_logarithm.h"

#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace rimpact::fe {
namespace {

constexpr int row_of[6] = {0, 1, 2, 0, 1, 2};
constexpr int column_of[6] = {0, 1, 2, 1, 2, 0};

/// Principal Kirchhoff stresses (deviatoric) after the return map, and their derivative with respect to the
/// trial logarithmic strains.
struct PrincipalReturn {
  Eigen::Vector3d elastic_strain; ///< deviatoric
  Eigen::Vector3d stress;
  Matrix3 moduli;
  double alpha;
  double overstress = 0.0; ///< [Pa]
};

/// Plastic part of a step: the change of the elastic strain's norm, and its own change with the trial stress's.
struct Flow {
  double gamma;
  double share; ///< 2 mu d gamma / d |trial stress| [-], between 0 (elastic) and 1 (no hardening)
  double overstress = 0.0;
};

Matrix3 deviatoric_projector() {
  return Matrix3::Identity() - Matrix3::Constant(1.0 / 3.0);
}

/// Beyond the static yield surface by `excess` [Pa] of |dev tau|. The bilinear curve of static steel is solved exactly,
/// all else in terms of the equivalent stress sqrt(3/2) |dev tau|.
Flow flow_beyond(const HenckyJ2 &law, double excess, double alpha, double soft, double dt) {
  const double mu = law.shear_modulus;
  if (law.hardening.is_linear() && law.heat.none() && (law.rate.none() || !(dt > 0))) {
    const double slope = law.hardening.slope(alpha);
    return {excess / (2 * mu + 2.0 / 3.0 * slope), 2 * mu / (2 * mu + 2.0 / 3.0 * slope)};
  }
  const StepFlow step =
      flow_of(law.hardening, law.rate,
              {.excess = std::sqrt(1.5) * excess, .alpha = alpha, .elastic = 3 * mu, .dt = dt, .softening = soft});
  return {std::sqrt(1.5) * step.flow, 3 * mu * step.by_trial,
          (soft * step.overstress + (soft - 1)) * law.hardening.stress(alpha + step.flow)};
}

/// Radial return in principal axes: |dev tau| = sqrt(2/3) times the flow stress.
PrincipalReturn return_map(const HenckyJ2 &law, const Eigen::Vector3d &trial_deviator, const J2State &old, double dt) {
  const double mu = law.shear_modulus, alpha = old.alpha, soft = law.softening(old);
  PrincipalReturn result{trial_deviator, 2 * mu * trial_deviator, 2 * mu * deviatoric_projector(), alpha};
  if (law.elastic) return result;
  const double norm = result.stress.norm();
  const double excess = norm - std::sqrt(2.0 / 3.0) * soft * law.hardening.stress(alpha);
  if (excess <= 0) return result;
  const auto [gamma, share, overstress] = flow_beyond(law, excess, alpha, soft, dt);
  const Eigen::Vector3d direction = result.stress / norm;
  result.elastic_strain -= gamma * direction;
  result.stress = 2 * mu * result.elastic_strain;
  result.alpha = alpha + std::sqrt(2.0 / 3.0) * gamma;
  result.overstress = overstress;
  const double theta = 1 - 2 * mu * gamma / norm;
  const double theta_bar = share - (1 - theta);
  result.moduli = 2 * mu * theta * deviatoric_projector() - 2 * mu * theta_bar * direction * direction.transpose();
  return result;
}

/// Spatial tangent from principal moduli (Simo 1998, eq. 46.28): normal part in the dyads m_i x m_j, shear
/// part with the divided difference (tau_i b_j - tau_j b_i)/(b_i - b_j), or its limit at equal stretches.
Matrix6 assemble_tangent(const PrincipalReturn &principal, const Eigen::Vector3d &b, const Matrix3 &axes) {
  constexpr int pair_first[3] = {0, 1, 2}, pair_second[3] = {1, 2, 0};
  Eigen::Matrix<double, 6, 3> normal,
      sheared; // columns: symmetrised dyads n_i n_i, and n_i n_j (i != j), in Voigt form
  for (int v = 0; v < 6; ++v)
    for (int k = 0; k < 3; ++k) {
      const int r = row_of[v], c = column_of[v], i = pair_first[k], j = pair_second[k];
      normal(v, k) = axes(r, k) * axes(c, k);
      sheared(v, k) = axes(r, i) * axes(c, j) + axes(r, j) * axes(c, i);
    }
  Matrix3 moduli = principal.moduli;
  moduli.diagonal() -= 2 * principal.stress;
  Eigen::Vector3d shear;
  for (int k = 0; k < 3; ++k) {
    const int i = pair_first[k], j = pair_second[k];
    const double difference = b(i) - b(j);
    // A divided difference loses digits as the stretches meet; below 1e-6 the limit is the better value.
    if (std::abs(difference) > 1e-6 * (b(i) + b(j)))
      shear(k) = (principal.stress(i) * b(j) - principal.stress(j) * b(i)) / difference;
    else
      shear(k) =
          0.25 * (principal.moduli(i, i) - principal.moduli(i, j) + principal.moduli(j, j) - principal.moduli(j, i)) -
          0.5 * (principal.stress(i) + principal.stress(j));
  }
  return (normal * moduli).lazyProduct(normal.transpose()) +
         (sheared * shear.asDiagonal()).lazyProduct(sheared.transpose());
}

/// Without the axes of b. Empty where it flows, or where b is far from unity.
std::optional<IsochoricResult> elastic_step(const HenckyJ2 &law, const Matrix3 &b, const J2State &old) {
  const auto logarithm = small_logarithm(b);
  if (!logarithm) return {};
  const Matrix3 deviator = 0.5 * *logarithm - logarithm->trace() / 6 * Matrix3::Identity();
  const double norm = deviator.norm();
  if (!law.elastic &&
      2 * law.shear_modulus * norm > std::sqrt(2.0 / 3.0) * law.softening(old) * law.hardening.stress(old.alpha))
    return {};
  IsochoricResult result;
  result.energy = law.shear_modulus * norm * norm;
  result.response.stress = to_vector(2 * law.shear_modulus * deviator);
  result.state = old;
  result.state.overstress = 0;
  return result;
}

/// The state after a flow but for what no force depends on; `pulled`: principal axes brought back by F^-1.
void flow_on(const J2State &old, const PrincipalReturn &principal, double mean_strain, const Matrix3 &pulled,
             J2State &state) {
  const Eigen::Vector3d b_elastic = (2 * (principal.elastic_strain.array() + mean_strain)).exp();
  state.cp_inverse = to_vector(pulled * b_elastic.asDiagonal() * pulled.transpose());
  // As the ledgers take the work of the stresses: by the trapezoid over the step.
  state.viscous_work += 0.5 * (old.overstress + principal.overstress) * (principal.alpha - old.alpha);
  state.alpha = principal.alpha, state.overstress = principal.overstress;
}

} // namespace

double lode_parameter(double determinant, double q) {
  return 13.5 * determinant / (q * q * q);
}

Matrix3 to_matrix(const Vector6 &s) {
  Matrix3 m;
  m << s(0), s(3), s(5), s(3), s(1), s(4), s(5), s(4), s(2);
  return m;
}

Vector6 to_vector(const Matrix3 &m) {
  return (Vector6() << m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(2, 0)).finished();
}

HenckyJ2 HenckyJ2::from(const scene::Material &material) {
  HenckyJ2 law{material.E / (2 * (1 + material.nu)), !material.yield.has_value()};
  if (!material.yield) return law;
  law.hardening = Hardening(material);
  law.rate = {material.rate};
  law.backstress = BackstressLaw(material);
  law.heat = {material.heat, material.density};
  return law;
}

HenckyJ2 HenckyJ2::at_rest() const {
  HenckyJ2 law = *this;
  law.elastic = true;
  return law;
}

IsochoricResult HenckyJ2::step(const J2State &old, const Matrix3 &F, double dt, bool with_tangent) const {
  IsochoricResult result;
  const double J = F.determinant();
  if (!(J > 0) || !std::isfinite(J)) {
    result.admissible = false;
    return result;
  }
  if (!elastic && !backstress.none()) return kinematic_step(*this, old, F, dt, with_tangent);
  const Matrix3 b_trial = F * to_matrix(old.cp_inverse) * F.transpose();
  if (!with_tangent)
    if (auto simple = elastic_step(*this, b_trial, old)) return *simple;
  // The iterative solver: Eigen's closed form returns parallel axes for nearly equal eigenvalues (F close to
  // I).
  const Eigen::SelfAdjointEigenSolver<Matrix3> spectrum(b_trial);
  const Eigen::Vector3d &b = spectrum.eigenvalues();
  const Matrix3 &axes = spectrum.eigenvectors();
  if (!(b.minCoeff() > 0)) {
    result.admissible = false;
    return result;
  }
  const Eigen::Vector3d strain = 0.5 * b.array().log();
  const Eigen::Vector3d deviator = strain.array() - strain.mean();
  const PrincipalReturn principal = return_map(*this, deviator, old, dt);

  result.energy = shear_modulus * principal.elastic_strain.squaredNorm();
  result.response.stress = to_vector(axes * principal.stress.asDiagonal() * axes.transpose());
  if (with_tangent) result.response.tangent = assemble_tangent(principal, b, axes);
  result.state = old;
  result.state.overstress = 0;
  if (!(principal.alpha > old.alpha)) return result;
  flow_on(old, principal, strain.mean(), F.inverse() * axes, result.state);
  const double q = std::sqrt(1.5) * principal.stress.norm();
  result.state.lode += lode_parameter(principal.stress.prod(), q) * (principal.alpha - old.alpha);
  result.mises = hardening.stress(principal.alpha) + principal.overstress;
  return result;
}

HenckyVolumetric HenckyVolumetric::from(const scene::Material &material) {
  return {material.E / (3 * (1 - 2 * material.nu))};
}

VolumetricResult HenckyVolumetric::at(double J) const {
  VolumetricResult result;
  if (!(J > 0) || !std::isfinite(J)) {
    result.admissible = false;
    return result;
  }
  const double log_J = std::log(J), pressure = bulk_modulus * log_J;
  result.energy = 0.5 * bulk_modulus * log_J * log_J;
  result.response.stress << pressure, pressure, pressure, 0, 0, 0;
  Matrix6 c = Matrix6::Zero();
  c.topLeftCorner<3, 3>().setConstant(bulk_modulus);
  for (int i = 0; i < 3; ++i) {
    c(i, i) -= 2 * pressure;
    c(3 + i, 3 + i) -= pressure;
  }
  result.response.tangent = c;
  return result;
}

} // namespace rimpact::fe

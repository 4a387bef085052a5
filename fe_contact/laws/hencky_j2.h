/// Finite-strain J2 plasticity with Hencky (logarithmic) elasticity, split into its isochoric and volumetric
/// parts so that an element may integrate the two with different quadratures (selective reduction).
///
/// Multiplicative split F = F_e F_p, b_e = F C_p^-1 F^T, exponential map in principal axes (Simo 1992; Simo
/// and Hughes, Computational Inelasticity, box 9.1). Stored energy per reference volume
///   Psi = mu |dev eps_e|^2 + kappa/2 (ln J)^2 + integral of the hardening curve,
/// flow stress that of the hardening curve, times 1 + w where the steel knows its rate (strain_rate.h), Kirchhoff
/// stress tau = 2 mu dev eps_e + kappa ln J 1. The yield surface is centred on a backstress where the steel has one
/// (kinematic_step.h). Signs: tension positive. Units: Pa, J/m^3.
#pragma once
#include "fe_contact/laws/backstress.h"
#include "fe_contact/laws/hardening.h"
#include "fe_contact/laws/softening.h"
#include "fe_contact/laws/strain_rate.h"
#include "scene/material.h"
#include <Eigen/Core>

namespace rimpact::fe {

using Matrix3 = Eigen::Matrix3d;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
/// Symmetric tensors as (xx, yy, zz, xy, yz, zx).
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Memory of a material point.
struct J2State {
  Vector6 cp_inverse{1.0, 1.0, 1.0, 0.0, 0.0, 0.0}; ///< C_p^-1
  double alpha = 0.0;                               ///< accumulated plastic strain [-]
  /// Flow stress over the hardening curve's at the last step's end, below 0 where heat softens more than the rate
  /// hardens [Pa]; 0: it did not flow.
  double overstress = 0.0;
  double viscous_work = 0.0; ///< integral of the overstress over alpha [J/m^3]
  /// Deviators in the intermediate configuration, which U_p unloads (kinematic_step.h) [Pa].
  Backstress backstress{Tensor6::Zero(), Tensor6::Zero()};
  double back_work = 0.0; ///< work of the backstress on the plastic strain [J/m^3]
  // Of what the steel went through; no force depends on them:
  double triaxiality = 0.0;  ///< integral of the triaxiality over alpha [-]
  double lode = 0.0;         ///< integral of the Lode parameter over alpha [-]
  double damage = 0.0;       ///< D of CrackMeasure by Johnson and Cook [-]
  double locus_damage = 0.0; ///< by Bao and Wierzbicki [-]
};

/// Kirchhoff stress and its tangent c of the Lie derivative (L_v tau = c : d), in Voigt form with engineering
/// shear rates; c has minor symmetry and, but for a backstress that is turned, major symmetry.
struct StressAndTangent {
  Vector6 stress;  ///< [Pa]
  Matrix6 tangent; ///< [Pa]
};

struct IsochoricResult {
  StressAndTangent response;
  J2State state;       ///< at the end of the step
  double energy = 0.0; ///< elastic, isochoric [J/m^3]
  /// Where it flows: the equivalent stress sqrt(3/2) |dev tau|, and no less than the yield surface's radius, which it
  /// can fall below about a backstress [Pa]. Triaxiality and Lode parameter divide by it (crack_measure.h).
  double mises = 0.0;
  bool admissible = true; ///< false: det F <= 0 or not finite; nothing else is then valid
};

/// Isochoric part with plasticity.
struct HenckyJ2 {
  double shear_modulus; ///< mu [Pa], > 0
  bool elastic = false; ///< never yields
  Hardening hardening{};
  RateLaw rate{};
  BackstressLaw backstress{};
  SofteningLaw heat{};

  static HenckyJ2 from(const scene::Material &material);
  /// Whether the plastic work is that of the hardening curve alone.
  bool follows_its_curve() const { return rate.none() && backstress.none() && heat.none(); }
  /// Plastic work of a state, all parts [J/m^3].
  double plastic_work(const J2State &state) const {
    return hardening.work(state.alpha) + state.viscous_work + state.back_work;
  }
  double softening(const J2State &state) const { return heat.none() ? 1 : heat.factor(plastic_work(state)); }
  /// The same that never yields: from the state at a step's end its stress is that of the step. To flow again,
  /// infinitely slowly, would relax what the rate bears.
  HenckyJ2 at_rest() const;
  /// F: deformation gradient at the end of the step; old: state at its start; dt: its length [s], 0: infinitely slow,
  /// the steel shows no rate. The tangent is made if it is asked for.
  IsochoricResult step(const J2State &old, const Matrix3 &F, double dt = 0, bool with_tangent = true) const;
};

struct VolumetricResult {
  StressAndTangent response;
  double energy = 0.0;
  bool admissible = true;
};

/// Volumetric part: pressure kappa ln J (Kirchhoff).
struct HenckyVolumetric {
  double bulk_modulus; ///< kappa [Pa], > 0
  static HenckyVolumetric from(const scene::Material &material);
  VolumetricResult at(double J) const;
};

/// 27 J3 / (2 q^3) of a deviator, q its equivalent stress: 1 in tension, 0 in shear, -1 in compression.
double lode_parameter(double determinant, double q);

Matrix3 to_matrix(const Vector6 &symmetric);
Vector6 to_vector(const Matrix3 &symmetric);

} // namespace rimpact::fe

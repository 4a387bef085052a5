/// Kinematic hardening: the backstress that the yield surface is centred on, a sum of at most two terms of Armstrong
/// and Frederick (1966; Chaboche 1986), with the plastic strain rate d eps_p and the accumulated plastic strain alpha
///   d B_k = 2/3 C_k d eps_p - gamma_k B_k d alpha.
/// In tension sqrt(3/2) |B_k| tends to C_k / gamma_k; gamma_k = 0 is Prager's straight line. Backward Euler over a
/// step:
///   B_k = theta_k (B_k,old + sqrt(2/3) C_k flow n),   theta_k = 1 / (1 + gamma_k flow),
/// with n the unit direction of the flow and `flow` the change of alpha. Units: Pa.
///
/// Symmetric tensors are six numbers (xx, yy, zz, sqrt(2) xy, sqrt(2) yz, sqrt(2) zx), so that their product is the
/// tensors' own.
#pragma once
#include "scene/material.h"
#include <array>
#include <Eigen/Core>

namespace rimpact::fe {

/// A symmetric tensor in the form above, and a map between such.
using Tensor6 = Eigen::Matrix<double, 6, 1>;
using Map6 = Eigen::Matrix<double, 6, 6>;
/// Deviators, one a term [Pa].
using Backstress = std::array<Tensor6, scene::most_backstresses>;

/// What is left of the old backstress after a flow: the sum of theta_k B_k, and its change with the flow.
struct FadedBackstress {
  Tensor6 sum;    ///< [Pa]
  Tensor6 change; ///< [Pa]
};

class BackstressLaw {
public:
  BackstressLaw() = default; ///< none at all
  explicit BackstressLaw(const scene::Material &material);

  bool none() const { return n_ == 0; }
  FadedBackstress faded(const Backstress &old, double flow) const; ///< flow >= 0
  /// Growth of the backstress's equivalent stress by a flow in its direction, the sum of theta_k C_k flow [Pa].
  double growth(double flow) const;
  double growth_slope(double flow) const; ///< [Pa]
  /// At a step's end; n: |n| = 1.
  Backstress next(const Backstress &old, double flow, const Tensor6 &n) const;

private:
  int n_ = 0; ///< of the terms
  std::array<double, scene::most_backstresses> C_{}, gamma_{};
};

} // namespace rimpact::fe

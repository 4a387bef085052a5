/// Static flow stress of steel over the accumulated plastic strain alpha >= 0 (isotropic hardening):
///   bilinear         yield + H alpha,  H = E E_t / (E - E_t)
///   table            straight between rows, beyond the last one its stress
///   Swift (1952)     K (e0 + alpha)^n
///   Voce (1948)      yield + Q (1 - exp(-b alpha))
///   Ludwik (1909)    yield + K alpha^n
/// None of them falls. Units: Pa.
#pragma once
#include "scene/material.h"
#include <array>
#include <vector>

namespace rimpact::fe {

class Hardening {
public:
  Hardening() = default; ///< no stress at all: of a solid that stays elastic
  /// The material must yield. Throws InputError for a curve that is none.
  explicit Hardening(const scene::Material &material);

  bool is_linear() const { return law_ == scene::HardeningLaw::bilinear; }
  double stress(double alpha) const { return is_linear() ? yield_ + modulus_ * alpha : curve(alpha).stress; }
  double slope(double alpha) const { return is_linear() ? modulus_ : curve(alpha).slope; } ///< infinite: Ludwik's at 0
  /// Integral of the stress from 0 to alpha [J/m^3].
  double work(double alpha) const {
    return is_linear() ? alpha * (yield_ + 0.5 * modulus_ * alpha) : curve(alpha).work;
  }

private:
  struct Point {
    double stress, slope, work;
  };
  Point curve(double alpha) const;
  Point between_rows(double alpha) const;

  scene::HardeningLaw law_ = scene::HardeningLaw::bilinear;
  double yield_ = 0, modulus_ = 0;
  double K_ = 0, e0_ = 0, n_ = 0, Q_ = 0, b_ = 0;
  std::vector<std::array<double, 2>> rows_; ///< alpha, stress
  std::vector<double> work_;                ///< up to each row [J/m^3]
};

} // namespace rimpact::fe

/// How near ductile steel is to a crack, by two loci of the plastic strain at fracture over the triaxiality eta, mean
/// stress over von Mises stress, tension positive:
///   Johnson and Cook (Engineering Fracture Mechanics 21, 1985)   D1 + D2 exp(D3 eta)
///   Bao and Wierzbicki (International Journal of Mechanical Sciences 46, 2004, as Lee 2005 has it), with eta_0 = 1/3
///     C1 / (1 + 3 eta)                    -1/3 < eta <= 0
///     C1 + (C2 - C1) (eta / eta_0)^2         0 < eta <= eta_0
///     C2 eta_0 / eta                     eta_0 < eta
/// Steel with a backstress flows at any equivalent stress, zero too, where mean stress over it has no bound and the
/// integral none: there the yield surface's radius stands in its place, the resistance of the steel around a void, by
/// which Rice and Tracey (Journal of the Mechanics and Physics of Solids 17, 1969) divide. Both are the same without a
/// backstress.
/// D = integral of d alpha / eps_f(eta); a crack begins at D = 1. Below eta = -1/3 nothing cracks by either (Bao and
/// Wierzbicki, Engineering Fracture Mechanics 72, 2005). Rate, temperature and Lode angle are left out.
#pragma once
#include "scene/material.h"
#include <cmath>

namespace rimpact::fe {

class CrackMeasure {
public:
  CrackMeasure() = default;
  explicit CrackMeasure(const scene::Fracture &constants)
      : constants_(constants), locus_(scene::fracture_locus(constants)) {}

  /// Plastic strain at fracture under a constant triaxiality [-]; infinite where nothing cracks. By Johnson and Cook:
  double fracture_strain(double triaxiality) const {
    return triaxiality < none_below ? HUGE_VAL : constants_.D1 + constants_.D2 * std::exp(constants_.D3 * triaxiality);
  }
  /// By Bao and Wierzbicki:
  double locus_strain(double triaxiality) const {
    if (triaxiality <= none_below) return HUGE_VAL;
    if (triaxiality <= 0) return locus_.shear / (1 + 3 * triaxiality);
    if (triaxiality > in_tension) return locus_.tension * in_tension / triaxiality;
    return locus_.shear + (locus_.tension - locus_.shear) * std::pow(triaxiality / in_tension, 2);
  }

private:
  static constexpr double none_below = -1.0 / 3.0, in_tension = 1.0 / 3.0;
  scene::Fracture constants_{};
  scene::FractureLocus locus_ = scene::fracture_locus({});
};

} // namespace rimpact::fe

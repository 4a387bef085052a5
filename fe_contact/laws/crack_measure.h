/// How near ductile steel is to a crack: Johnson and Cook's fracture strain (Engineering Fracture Mechanics 21, 1985),
///   eps_f(eta) = D1 + D2 exp(D3 eta),   D = integral of d alpha / eps_f,
/// eta the triaxiality, mean stress over von Mises stress; tension positive. A crack begins at D = 1. Below eta = -1/3
/// nothing cracks (Bao and Wierzbicki, Engineering Fracture Mechanics 72, 2005). Rate and temperature are left out.
#pragma once
#include "scene/material.h"
#include <cmath>

namespace rimpact::fe {

struct CrackMeasure {
  scene::Fracture constants{};

  /// Plastic strain at fracture under a constant triaxiality [-]; infinite where nothing cracks.
  double fracture_strain(double triaxiality) const {
    constexpr double none_below = -1.0 / 3.0;
    return triaxiality < none_below ? HUGE_VAL : constants.D1 + constants.D2 * std::exp(constants.D3 * triaxiality);
  }
};

} // namespace rimpact::fe

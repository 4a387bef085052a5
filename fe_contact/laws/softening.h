/// Flow stress that falls as plastic work heats the steel, none of the heat being led away (Johnson and Cook 1983):
///   sigma = sigma_s(alpha) (1 + w) (1 - (dT / dT_m)^m),   dT = beta W_p / (rho c)
/// with W_p the plastic work and beta its share that becomes heat. The factor is that of the work at a step's start: an
/// error of the step's first order, in a fall of a few per cent. Closed form of a bar that would flow at sigma_0 for
/// ever, m = 1: sigma = sigma_0 exp(-beta sigma_0 alpha / (rho c dT_m)).
#pragma once
#include "scene/material.h"
#include <algorithm>
#include <cmath>

namespace rimpact::fe {

struct SofteningLaw {
  scene::PlasticHeat data{};
  double density = 0; ///< [kg/m^3]; > 0 where the model is one

  bool none() const { return data.model == scene::Softening::none; }
  /// Rise of the temperature after plastic work [J/m^3], >= 0, in K.
  double rise(double work) const { return data.share * work / (density * data.capacity); }
  /// Of the flow stress [-]: 1 without a law; 0.01 where the steel would melt, for it must stay solid.
  double factor(double work) const {
    if (none()) return 1;
    constexpr double least = 0.01;
    return std::max(least, 1 - std::pow(std::max(0.0, rise(work)) / data.melting, data.exponent));
  }
};

} // namespace rimpact::fe

/// Flow stress that grows with the plastic strain rate.
///
/// Flow stress = sigma_s(alpha) (1 + w), with sigma_s the static one and w >= 0 the relative overstress at the rate
/// d alpha / dt:
///   Cowper and Symonds (1957): w = (rate / D)^(1/q)
///   Johnson and Cook (1983), rate term: w = C ln(max(1, rate / reference))
/// Both are used the other way round, rate = D w^q or reference e^(w/C), which rises, convex, with w. Units: Pa, s.
#pragma once
#include "scene/material.h"

namespace rimpact::fe {

struct PlasticRate {
  double value; ///< d alpha / dt [1/s], >= 0
  double slope; ///< d value / d w [1/s]
};

/// The law; a steel without one has the model `none`, and nothing here may be asked of it.
struct RateLaw {
  scene::StrainRate data{};
  bool none() const { return data.model == scene::RateModel::none; }
  double overstress(double rate) const;      ///< rate [1/s] >= 0 -> w [-]
  PlasticRate rate(double overstress) const; ///< w [-] >= 0 -> the rate; at w = 0 the largest one without overstress
};

} // namespace rimpact::fe

/// Flow stress that grows with the plastic strain rate, and the flow of a step in time that is implicit in it.
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

/// A step beyond yield, in terms of equivalent stress.
struct FlowStep {
  double excess;  ///< trial stress over the static flow stress at the step's start [Pa], > 0
  double stress;  ///< that static flow stress [Pa], > 0
  double slope;   ///< of the static hardening curve [Pa], >= 0, the same over the step
  double elastic; ///< fall of the stress by flow, 3 mu [Pa], > 0
  double dt;      ///< [s], > 0
};

struct StepFlow {
  double flow;       ///< change of alpha [-], >= 0
  double by_trial;   ///< d flow / d trial stress [1/Pa], between 0 and 1 / (elastic + slope)
  double overstress; ///< w at the step's end [-], >= 0
};

/// Solves excess = stress w + (elastic + slope (1 + w)) dt rate(w) for w >= 0, by Newton's method from above, which
/// a convex function lets fall to its root without overshooting.
StepFlow flow_of(const RateLaw &law, const FlowStep &step);

} // namespace rimpact::fe

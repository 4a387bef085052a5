/// The flow of a step in time beyond yield: implicit in the hardening curve and in the law of the strain rate.
///
///   trial stress - fall(flow) = sigma_s(alpha + flow) (1 + w),   flow = dt rate(w)
/// with sigma_s the static flow stress (hardening.h) and w the relative overstress (strain_rate.h). Without a law of
/// the rate, or where the step takes no time, w = 0. Equivalent stresses and strains, Pa, s.
#pragma once
#include "fe_contact/laws/hardening.h"
#include "fe_contact/laws/strain_rate.h"
#include <functional>

namespace rimpact::fe {

/// A step beyond yield.
struct FlowStep {
  double excess;        ///< trial stress over the static flow stress at the step's start [Pa], > 0
  double alpha;         ///< accumulated plastic strain there [-], >= 0
  double elastic;       ///< fall of the stress by flow, 3 mu [Pa], > 0
  double dt;            ///< [s]; 0: infinitely slow
  double softening = 1; ///< factor of the static flow stress over the step [-], > 0
};

struct StepFlow {
  double flow;             ///< change of alpha [-], >= 0
  double by_trial;         ///< d flow / d trial stress [1/Pa], between 0 and 1 / elastic
  double overstress = 0.0; ///< w at the step's end [-], >= 0
};

/// Both sides' difference rises with the unknown (the flow, or w), so that it has one root between bounds that are
/// known: Newton's method, halving the bounds where it leaves them.
StepFlow flow_of(const Hardening &hardening, const RateLaw &law, const FlowStep &step);

/// Fall of the equivalent stress by flow, from 0 at no flow [Pa], and its slope, at least `elastic` [Pa].
struct FallOfStress {
  double value, slope;
};
/// The same where the stress does not fall as elastic * flow, for what it is measured from moves too.
StepFlow flow_of(const Hardening &hardening, const RateLaw &law, const FlowStep &step,
                 const std::function<FallOfStress(double)> &fall);

} // namespace rimpact::fe

#include "fe_contact/laws/plastic_flow.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace rimpact::fe {
namespace {

struct ValueAndSlope {
  double value, slope;
};

/// Root of a rising function that is <= 0 at `low` and >= 0 at `high`, up to rounding.
template <class F> double rising_root(const F &f, double low, double high) {
  constexpr int enough = 200; // it takes 4 to 8, and some more where a curve begins steeply
  constexpr double rounding = 4e-16;
  double x = high;
  for (int k = 0; k < enough; ++k) {
    const auto [value, slope] = f(x);
    const double change = value / slope;
    if (std::abs(change) <= rounding * x) break;
    (value > 0 ? high : low) = x;
    const double next = x - change, middle = (low + high) / 2;
    if (next > low && next < high)
      x = next;
    else if (middle > low && middle < high)
      x = middle;
    else
      break; // the bounds have met
  }
  return x;
}

/// By the elastic strain alone.
struct ElasticFall {
  double elastic;
  FallOfStress operator()(double flow) const { return {elastic * flow, elastic}; }
};

/// Of steel that shows no rate.
template <class Fall> StepFlow static_flow(const Hardening &hardening, const FlowStep &step, const Fall &fall) {
  const double soft = step.softening, at_start = soft * hardening.stress(step.alpha);
  double flow = step.excess / step.elastic;
  if (std::is_same_v<Fall, ElasticFall> && hardening.is_linear())
    flow = step.excess / (step.elastic + soft * hardening.slope(step.alpha));
  else
    flow = rising_root(
        [&](double x) {
          const double end = step.alpha + x;
          const FallOfStress fallen = fall(x);
          return ValueAndSlope{fallen.value + (soft * hardening.stress(end) - at_start) - step.excess,
                               fallen.slope + soft * hardening.slope(end)};
        },
        0.0, flow);
  return {flow, 1 / (fall(flow).slope + soft * hardening.slope(step.alpha + flow))};
}

template <class Fall>
StepFlow flow_by(const Hardening &hardening, const RateLaw &law, const FlowStep &step, const Fall &fall) {
  const StepFlow at_once = static_flow(hardening, step, fall);
  if (law.none() || !(step.dt > 0) || law.rate(0).value >= at_once.flow / step.dt) return at_once;
  const double soft = step.softening, at_start = soft * hardening.stress(step.alpha);
  const auto balance = [&](double w) {
    const PlasticRate rate = law.rate(w);
    const double flow = step.dt * rate.value, end = step.alpha + flow, stress = soft * hardening.stress(end);
    const FallOfStress fallen = fall(flow);
    const double resistance = fallen.slope + soft * hardening.slope(end) * (1 + w);
    return ValueAndSlope{at_start * w + fallen.value + (stress - at_start) * (1 + w) - step.excess,
                         stress + resistance * step.dt * rate.slope};
  };
  // No flow at all, and the flow of static steel: both are at or above the root.
  const double w = rising_root(balance, 0.0, std::min(step.excess / at_start, law.overstress(at_once.flow / step.dt)));
  const PlasticRate rate = law.rate(w);
  return {step.dt * rate.value, step.dt * rate.slope / balance(w).slope, w};
}

} // namespace

StepFlow flow_of(const Hardening &hardening, const RateLaw &law, const FlowStep &step) {
  return flow_by(hardening, law, step, ElasticFall{step.elastic});
}

StepFlow flow_of(const Hardening &hardening, const RateLaw &law, const FlowStep &step,
                 const std::function<FallOfStress(double)> &fall) {
  return flow_by(hardening, law, step, fall);
}

} // namespace rimpact::fe

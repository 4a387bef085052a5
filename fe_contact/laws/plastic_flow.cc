#include "fe_contact/laws/plastic_flow.h"

#include <algorithm>
#include <cmath>

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

/// Of steel that shows no rate.
StepFlow static_flow(const Hardening &hardening, const FlowStep &step) {
  const double at_start = hardening.stress(step.alpha);
  double flow = step.excess / step.elastic;
  if (hardening.is_linear())
    flow = step.excess / (step.elastic + hardening.slope(step.alpha));
  else
    flow = rising_root(
        [&](double x) {
          const double end = step.alpha + x;
          return ValueAndSlope{step.elastic * x + (hardening.stress(end) - at_start) - step.excess,
                               step.elastic + hardening.slope(end)};
        },
        0.0, flow);
  return {flow, 1 / (step.elastic + hardening.slope(step.alpha + flow))};
}

} // namespace

StepFlow flow_of(const Hardening &hardening, const RateLaw &law, const FlowStep &step) {
  const StepFlow at_once = static_flow(hardening, step);
  if (law.none() || !(step.dt > 0) || law.rate(0).value >= at_once.flow / step.dt) return at_once;
  const double at_start = hardening.stress(step.alpha);
  const auto balance = [&](double w) {
    const PlasticRate rate = law.rate(w);
    const double flow = step.dt * rate.value, end = step.alpha + flow, stress = hardening.stress(end);
    const double resistance = step.elastic + hardening.slope(end) * (1 + w);
    return ValueAndSlope{at_start * w + step.elastic * flow + (stress - at_start) * (1 + w) - step.excess,
                         stress + resistance * step.dt * rate.slope};
  };
  // No flow at all, and the flow of static steel: both are at or above the root.
  const double w = rising_root(balance, 0.0, std::min(step.excess / at_start, law.overstress(at_once.flow / step.dt)));
  const PlasticRate rate = law.rate(w);
  return {step.dt * rate.value, step.dt * rate.slope / balance(w).slope, w};
}

} // namespace rimpact::fe

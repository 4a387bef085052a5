#include "fe_contact/laws/strain_rate.h"

#include <algorithm>
#include <cmath>

namespace rimpact::fe {
namespace {

bool by_power(const RateLaw &law) {
  return law.data.model == scene::RateModel::cowper_symonds;
}

} // namespace

double RateLaw::overstress(double rate) const {
  if (by_power(*this)) return std::pow(rate / data.D, 1 / data.q);
  return data.C * std::log(std::max(1.0, rate / data.reference));
}

PlasticRate RateLaw::rate(double overstress) const {
  if (by_power(*this)) {
    const double below = data.D * std::pow(overstress, data.q - 1);
    return {below * overstress, below * data.q};
  }
  const double value = data.reference * std::exp(overstress / data.C);
  return {value, value / data.C};
}

StepFlow flow_of(const RateLaw &law, const FlowStep &step) {
  constexpr int enough = 100; // it takes 4 to 8, and some more where the logarithm of the rate is large
  const double stiffness = step.elastic + step.slope, at_once = step.excess / stiffness;
  const double largest_rate = at_once / step.dt;
  if (law.rate(0).value >= largest_rate) return {at_once, 1 / stiffness, 0.0};
  double w = std::min(step.excess / step.stress, law.overstress(largest_rate)); // both are at or above the root
  for (int k = 0;; ++k) {
    const PlasticRate rate = law.rate(w);
    const double flow = step.dt * rate.value, by_overstress = step.dt * rate.slope,
                 resistance = step.elastic + step.slope * (1 + w);
    const double left = step.stress * w + resistance * flow - step.excess;
    const double slope = step.stress + step.slope * flow + resistance * by_overstress;
    const double lower = w - left / slope;
    if (k == enough || !(lower < w)) return {flow, by_overstress / slope, w}; // rounding alone is left
    w = lower;
  }
}

} // namespace rimpact::fe

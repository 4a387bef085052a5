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

} // namespace rimpact::fe

#include "scene/material.h"

#include <cmath>
#include <fmt/format.h>

namespace rimpact::scene {

FractureLocus fracture_locus(const Fracture &f) {
  constexpr double exponent = 0.2; // of structural steel
  const double tension = f.C2 > 0 ? f.C2 : f.D1 + f.D2 * std::exp(f.D3 / 3);
  return {f.C1 > 0 ? f.C1 : tension * std::pow(std::sqrt(0.75), 1 / exponent), tension};
}

std::string in_words(const StrainRate &rate) {
  switch (rate.model) {
  case RateModel::none:
    break;
  case RateModel::cowper_symonds:
    return fmt::format("{}, D = {:g} 1/s, q = {:g}", word(rate.model), rate.D, rate.q);
  case RateModel::johnson_cook:
    return fmt::format("{}, C = {:g}, reference {:g} 1/s", word(rate.model), rate.C, rate.reference);
  }
  return word(rate.model);
}

} // namespace rimpact::scene

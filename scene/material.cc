#include "scene/material.h"

#include <fmt/format.h>

namespace rimpact::scene {

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

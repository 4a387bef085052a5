#include "laws/impact/rims_in_series.h"
#include <cmath>

namespace rimpact::laws {
namespace {

/// The same force over depths, rates and dents of which one's are the share of the other's.
bool alike(const RimElement &one, const RimElement &all, int rims) {
  constexpr double rounding = 1e-9;
  for (const double d : {1e-4, 1e-3, 5e-3, 2e-2})
    for (const double rate : {-0.3, 0.0, 0.4})
      for (const double dent : {0.0, 2e-3, 1e-2}) {
        const double force =
            all.trial({.d = rims * d, .rate = rims * rate, .speed = rims * 0.5, .deepest = rims * dent});
        const double own = one.trial({.d = d, .rate = rate, .speed = 0.5, .deepest = dent});
        if (std::abs(own - force) > rounding * (std::abs(force) + 1)) return false;
      }
  return true;
}

} // namespace

std::optional<LawNumbers> one_in_series(const ImpactLaw &law, LawNumbers numbers, int rims) {
  if (law.pushed) return {};
  constexpr double any_mass = 1e5;
  const RimElement all = rim_element(law, numbers, any_mass);
  numbers.k_i *= rims;
  if (!law.of_mass && !alike(rim_element(law, numbers, any_mass), all, rims)) return {};
  return numbers;
}

} // namespace rimpact::laws

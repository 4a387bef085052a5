/// A lognormal of which the values beyond a stop are known only to lie there.
#pragma once
#include "studies/reliability/lognormal.h"
#include <optional>

namespace rimpact::reliability {

/// Sums over the logarithms of values below the stop, and how many lie at or beyond it.
struct CensoredSums {
  double n = 0, sum_ln = 0, sum_ln2 = 0; ///< of those below
  double n_beyond = 0;
};

/// Maximum likelihood (expectation and maximisation: Dempster, Laird and Rubin, J. R. Stat. Soc. B 39, 1977). None: no
/// two different values lie below the stop, or the search does not end. stop > 0.
std::optional<Lognormal> fit_censored(const CensoredSums &sums, double stop);

} // namespace rimpact::reliability

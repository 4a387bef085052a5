/// Responses of one level of intensity where a stop may be hit: runs that hit it and runs that do not, apart.
#pragma once
#include "studies/reliability/level.h"
#include <optional>

namespace rimpact::reliability {

/// Of the runs of a level that did not collapse, with h the probability of a hit:
///   P(Y > y) = n_collapsed / n + (1 - n_collapsed / n) [h P_hit(y) + (1 - h) P_free(y)].
/// P_hit and P_free are those of their runs' lognormals (level.h). A stop caps the response where every free run lies
/// below it and every hit one at or above it. F is then the lognormal of the free runs, with the others beyond
/// the stop (censored_lognormal.h). G is that of what the hit runs press the stop by:
///   P_free(y) = 1 - F(y) / F(stop) below it, else 0;  P_hit(y) = 1 up to it, else 1 - G(y - stop).
struct HitLevel {
  int n_collapsed = 0;
  LevelDistribution hit, free;         ///< without collapses; `hit` of what is beyond the stop, where there is one
  double hit_share = 0;                ///< h: counted, or smoothed over the levels by the caller
  std::optional<double> stop;          ///< > 0; none: the response is not capped
  std::optional<Lognormal> below_stop; ///< F; none: there is no stop, or the runs below it do not give it

  double counted_share() const; ///< of hits among the runs that did not collapse; 0 where there are none
  /// P(Y > limit), limit > 0. Throws InputError at limit <= 0.
  double exceedance(double limit) const;
};

/// Where a stop lies that no free run passes and every hit one does: the threshold of a lognormal through least, median
/// and largest hit, between the largest free response and the least hit. None: these overlap, or there is no hit.
std::optional<double> stop_between(double most_free, std::vector<double> hits);

/// `hit`: of responses less the stop, where there is one. Throws InputError where there is no run at all.
HitLevel hit_level(int n_collapsed, const LevelDistribution &hit, const LevelDistribution &free,
                   std::optional<double> stop);

} // namespace rimpact::reliability

/// Between which a failure rate lies whose fragility is known at levels of intensity only.
#pragma once
#include "studies/reliability/hazard.h"
#include <optional>
#include <vector>

namespace rimpact::reliability {

/// Probabilities of exceedance at the levels, in [0, 1]; both alike where they have no interval of their own.
struct LevelBounds {
  std::vector<double> least, most;
};

/// For a fragility that grows with intensity.
///   Above the last level: held flat there, or 1.
///   Between levels: the smaller or larger, at every intensity, of the straight line in ln x and of the lognormal
///   through both levels; the second meets a lognormal fragility exactly. Below the first level: nothing, or the larger
///   of a straight fall to 0 over the first step of the levels and of that of a lognormal fragility of deviation 1:
///   that none falls more slowly is an assumption.
struct RateRange {
  double least = 0;           ///< [1/year]
  std::optional<double> most; ///< none: not bounded by what is known
  /// What each of the three leaves open: parts of most - least.
  double above = 0, between = 0;
  std::optional<double> below;
};

/// Levels of growing intensity > 0, at least one. Throws InputError as failure_rate.
RateRange rate_range(const HazardCurve &hazard, const std::vector<double> &levels, const LevelBounds &bounds);

} // namespace rimpact::reliability

/// The failure rate of a fragility that is known at levels of intensity, and what of it belongs to each level.
#pragma once
#include "studies/reliability/binomial_fit.h"
#include "studies/reliability/level_weights.h"

namespace rimpact::reliability {

/// Rates [1/year].
struct LevelRate {
  double rate = 0;
  double below = 0, above = 0;   ///< parts of it from below the first and above the last level
  std::vector<double> of_levels; ///< parts that rest on each level's probability; they sum to `rate`
};

/// As LevelWeights has it (the thesis's own reading): straight lines between levels, flat above the last one.
LevelRate flat_rate(const LevelWeights &weights, const std::vector<double> &probabilities);

/// Between two levels whose probabilities lie between 0 and 1 the lognormal through both, else the straight line. Above
/// the last level the larger of its probability and `across`. Below the first one a lognormal through its probability,
/// of the deviation of `across`, at most slowest_fall. Where `across` is none, as flat_rate beyond both ends. Exact for
/// a lognormal fragility. What a step contributes is shared between its ends as the straight line shares it.
LevelRate fitted_rate(const HazardCurve &hazard, const LevelWeights &weights, const std::vector<double> &levels,
                      const std::vector<double> &probabilities, const std::optional<BinomialFit> &across);

} // namespace rimpact::reliability

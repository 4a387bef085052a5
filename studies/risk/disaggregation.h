/// Why a failure rate is what it is: shares by intensity and by record, and its sensitivity to what was sampled.
#pragma once
#include "studies/risk/evaluate.h"

namespace rimpact::risk {

struct Disaggregation {
  std::vector<double> levels; ///< share of the rate that rests on each level's probability (level_rate.h); sums to 1
  /// Share of each record: a level's share divided among its records as their runs beyond the limit are. What a level
  /// whose runs all stay below the limit contributes by its lognormal tail belongs to no record: the sum is 1 - tail.
  std::vector<double> records;
  double tail = 0;
  /// d ln(rate) / d ln(input) of each sampled key: the shift of the responses' logarithms, by their
  /// regression on the input's within records. Collapses, responses of 0 and the share of hits keep their counts. 0 for
  /// an input that is not > 0 in every run; NaN, not known, where a tenth and more of the rate is from levels without a
  /// lognormal.
  std::vector<double> elasticities;
};

/// All 0 where the rate is.
Disaggregation disaggregate(const ResponseSet &responses, const SystemSample &sample, const LimitResult &limit);

} // namespace rimpact::risk

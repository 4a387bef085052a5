/// Confidence bands by drawing the records anew (Efron 1979).
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

namespace rimpact::reliability {

/// Values of a statistic, one per point of a curve, for a set of records: `drawn` holds indices, some
/// repeated.
using Statistic = std::function<std::vector<double>(const std::vector<int> &drawn)>;

/// How the records are drawn. All runs of a record are drawn together: they are not independent.
struct Bootstrap {
  int replicates = 1000;   ///< >= 2
  double confidence = 0.9; ///< in (0, 1), both tails alike
  std::uint64_t seed = 1;  ///< the same seed gives the same band on every machine
  void validate() const;   ///< throws InputError naming value and bound
};

/// Pointwise percentile band.
struct Band {
  std::vector<double> low, high;
};

/// Throws InputError at n_records < 1. A single record gives a band of no width: nothing is known of the
/// scatter.
Band bootstrap_band(int n_records, const Statistic &statistic, const Bootstrap &options);

} // namespace rimpact::reliability

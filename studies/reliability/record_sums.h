/// Responses of the runs of one record at one level, as sums: what a lognormal fit needs of them, so that records can
/// be drawn anew without going back to the runs.
#pragma once
#include "studies/reliability/level.h"
#include <vector>

namespace rimpact::reliability {

struct RecordSums {
  int n_collapsed = 0, n_zero = 0, n_positive = 0;
  double sum_ln = 0, sum_ln2 = 0; ///< of the positive responses' logarithms and their squares
  /// A response >= 0 of a run that did not collapse.
  void add(double response);
};

/// A level as in level.h of the records together, each counted `times[i]` times. Where none counts, all its counts
/// are 0.
LevelDistribution pooled(const std::vector<RecordSums> &records, const std::vector<int> &times);

} // namespace rimpact::reliability

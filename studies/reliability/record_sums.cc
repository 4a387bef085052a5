#include "studies/reliability/record_sums.h"
#include <algorithm>
#include <cmath>

namespace rimpact::reliability {

void RecordSums::add(double response) {
  if (response == 0) {
    ++n_zero;
    return;
  }
  const double logarithm = std::log(response);
  ++n_positive, sum_ln += logarithm, sum_ln2 += logarithm * logarithm;
}

LevelDistribution pooled(const std::vector<RecordSums> &records, const std::vector<int> &times) {
  LevelDistribution level;
  double sum = 0, sum2 = 0;
  for (std::size_t i = 0; i < records.size(); ++i) {
    level.n_collapsed += times[i] * records[i].n_collapsed, level.n_zero += times[i] * records[i].n_zero;
    level.n_positive += times[i] * records[i].n_positive;
    sum += times[i] * records[i].sum_ln, sum2 += times[i] * records[i].sum_ln2;
  }
  if (level.n_positive == 0) return level;
  const double n = level.n_positive, mean = sum / n, square = sum2 / n;
  // The difference of two sums: below their rounding the responses are equal, a step.
  const double variance = square - mean * mean;
  const double sigma = variance > 1e-13 * std::max(1.0, square) ? std::sqrt(variance) : 0;
  level.fit = LognormalFit{.distribution = {.mean_ln = mean, .sigma_ln = sigma}, .n = level.n_positive};
  return level;
}

} // namespace rimpact::reliability

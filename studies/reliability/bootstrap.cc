#include "studies/reliability/bootstrap.h"
#include "io/files/error.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <random>

namespace rimpact::reliability {
namespace {

/// Linear between the sorted values, the first at p = 0 and the last at p = 1.
double quantile(const std::vector<double> &sorted, double p) {
  const double place = p * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

} // namespace

void Bootstrap::validate() const {
  if (replicates < 2) throw InputError(fmt::format("replicates {} is below 2", replicates));
  if (!(confidence > 0 && confidence < 1))
    throw InputError(fmt::format("confidence {} is not between 0 and 1", confidence));
}

Band bootstrap_band(int n_records, const Statistic &statistic, const Bootstrap &options) {
  options.validate();
  if (n_records < 1) throw InputError(fmt::format("a bootstrap needs at least 1 record, not {}", n_records));
  std::mt19937_64 generator(options.seed);
  std::vector<int> drawn(n_records);
  std::vector<std::vector<double>> by_point;
  for (int r = 0; r < options.replicates; ++r) {
    // The standard fixes the generator but not its distributions; the top 53 bits give [0, 1) everywhere.
    for (int &d : drawn) d = static_cast<int>(static_cast<double>(generator() >> 11) * 0x1p-53 * n_records);
    const auto values = statistic(drawn);
    by_point.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) by_point[i].push_back(values[i]);
  }
  Band band;
  for (auto &values : by_point) {
    std::sort(values.begin(), values.end());
    band.low.push_back(quantile(values, (1 - options.confidence) / 2));
    band.high.push_back(quantile(values, (1 + options.confidence) / 2));
  }
  return band;
}

} // namespace rimpact::reliability

#include "io/records/header_check.h"
#include "io/files/error.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace rimpact {

void take_mean_off(SampledSignal &signal) {
  const double mean = std::accumulate(signal.values.begin(), signal.values.end(), 0.0) /
                      static_cast<double>(std::max<std::size_t>(1, signal.values.size()));
  for (double &value : signal.values) value -= mean;
}

void require_count(const std::string &path, const char *key, double stated, std::size_t found) {
  if (static_cast<double>(found) == stated) return;
  throw DataError(fmt::format("{}: {}: {} values found, {} promises {:.0f}", path,
                              static_cast<double>(found) < stated ? "truncated" : "more values than promised", found,
                              key, stated));
}

void require_peak(const std::string &path, const char *key, double stated, const SampledSignal &record, double slack) {
  const double largest = peak_of(record.values);
  constexpr double rounding = 1e-4; // of a header that gives few digits [m/s^2]
  if (stated == 0 || std::abs(largest - std::abs(stated)) <= slack * std::abs(stated) + rounding) return;
  throw DataError(fmt::format("{}: {} says {:.5g} m/s^2, the values reach {:.5g} m/s^2: header and data disagree", path,
                              key, std::abs(stated), largest));
}

} // namespace rimpact

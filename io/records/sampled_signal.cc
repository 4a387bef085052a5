#include "io/records/sampled_signal.h"

#include <algorithm>
#include <cmath>

namespace rimpact {

double SampledSignal::at(double t) const {
  if (values.empty() || t < start || t > end()) return 0;
  const double position = (t - start) / dt;
  const auto i = static_cast<std::size_t>(position);
  if (i + 1 >= values.size()) return values.back();
  const double share = position - static_cast<double>(i);
  return values[i] + share * (values[i + 1] - values[i]);
}

double peak_of(const std::vector<double> &values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

} // namespace rimpact

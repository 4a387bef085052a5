#include "io/records/scaled_copies.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace rimpact {
namespace {

std::size_t place_of_peak(const std::vector<double> &values) {
  return static_cast<std::size_t>(
      std::max_element(values.begin(), values.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      values.begin());
}

bool is_multiple(const std::vector<double> &values, const std::vector<double> &of, double factor, double peak) {
  constexpr double rounding = 1e-3; // of files with few digits
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::abs(values[i] - factor * of[i]) > rounding * peak) return false;
  return true;
}

} // namespace

std::vector<std::optional<ScaledCopy>> scaled_copies(const std::vector<std::shared_ptr<const SampledSignal>> &records) {
  std::vector<std::optional<ScaledCopy>> copies(records.size());
  std::map<std::tuple<std::size_t, double, std::size_t>, std::vector<std::size_t>>
      alike; ///< samples, step, peak's place
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (!records[i] || records[i]->values.empty()) continue;
    const auto &values = records[i]->values;
    const std::size_t at = place_of_peak(values);
    if (values[at] == 0) continue;
    auto &others = alike[{values.size(), records[i]->dt, at}];
    for (const std::size_t other : others) {
      const double factor = values[at] / records[other]->values[at];
      if (!is_multiple(values, records[other]->values, factor, std::abs(values[at]))) continue;
      copies[i] = ScaledCopy{other, factor};
      break;
    }
    if (!copies[i]) others.push_back(i);
  }
  return copies;
}

} // namespace rimpact

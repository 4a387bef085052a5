#include "calibration/data/sample_noise.h"
#include <algorithm>
#include <cmath>

namespace rimpact::calibration {

namespace {

constexpr double significant = 3; ///< standard errors
constexpr std::size_t few = 8;

/// Mean product of what two samples `apart` are off their mean, of pairs that are both counted; their number.
std::pair<double, double> product(const std::vector<double> &off, const std::vector<bool> &counted, std::size_t apart) {
  double sum = 0, n = 0;
  for (std::size_t i = 0; i + apart < off.size(); ++i)
    if (counted[i] && counted[i + apart]) sum += off[i] * off[i + apart], ++n;
  return {n > 0 ? sum / n : 0, n};
}

} // namespace

double correlation_of(const std::vector<double> &values, const std::vector<bool> &counted) {
  double mean = 0, n = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (counted[i]) mean += values[i], ++n;
  if (n < few) return 1;
  std::vector<double> off = values;
  for (double &value : off) value -= mean / n;
  const double variance = product(off, counted, 0).first;
  if (!(variance > 0)) return 1;
  double tau = 1;
  for (std::size_t apart = 1; apart < values.size(); ++apart) {
    const auto [covariance, pairs] = product(off, counted, apart);
    if (!(pairs >= few) || covariance / variance <= significant / std::sqrt(pairs)) break;
    tau += 2 * covariance / variance;
  }
  return std::min(tau, std::max(1.0, n / 10));
}

double noise_of_differences(const std::vector<double> &values) {
  std::vector<double> d;
  for (std::size_t i = 3; i < values.size(); ++i)
    d.push_back(values[i] - 3 * values[i - 1] + 3 * values[i - 2] - values[i - 3]);
  return scatter_of(std::move(d)) / std::sqrt(20.0);
}

std::vector<double> about_line(std::vector<double> values) {
  const double n = static_cast<double>(values.size()), middle = 0.5 * (n - 1);
  double mean = 0, slope = 0, square = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double at = static_cast<double>(i) - middle;
    mean += values[i] / n, slope += at * values[i], square += at * at;
  }
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] -= mean + (square > 0 ? slope / square : 0) * (static_cast<double>(i) - middle);
  return values;
}

double scatter_of(std::vector<double> values) {
  constexpr double median_of_normal = 0.6745; // of its absolute value, in standard deviations
  if (values.empty()) return 0;
  for (double &value : values) value = std::abs(value);
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2] / median_of_normal;
}

double step_of_digits(const std::vector<double> &values) {
  constexpr double same = 1e-9, finest = 1e-4, whole = 0.02; // of the range; of a step
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  if (sorted.empty() || !(sorted.back() > sorted.front())) return 0;
  const double range = sorted.back() - sorted.front();
  double step = range;
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (const double gap = sorted[i] - sorted[i - 1]; gap > same * range) step = std::min(step, gap);
  if (step < finest * range || step > 0.5 * range) return 0;
  double steps = 0; // the smallest gap is off by the rounding of its own text, the whole range is not
  for (std::size_t i = 1; i < sorted.size(); ++i) steps += std::round((sorted[i] - sorted[i - 1]) / step);
  step = range / steps;
  const bool in_steps = std::all_of(sorted.begin(), sorted.end(), [&](double value) {
    const double n = (value - sorted.front()) / step;
    return std::abs(n - std::round(n)) < whole;
  });
  return in_steps ? step : 0;
}

double noise_of_digits(const std::vector<double> &values) {
  return step_of_digits(values) / std::sqrt(12.0);
}

} // namespace rimpact::calibration

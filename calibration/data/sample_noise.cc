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

double noise_of_differences(const std::vector<double> &v, std::size_t n, std::size_t apart) {
  std::vector<double> d;
  for (std::size_t i = 3 * apart; i < n; ++i)
    d.push_back(std::abs(v[i] - 3 * v[i - apart] + 3 * v[i - 2 * apart] - v[i - 3 * apart]));
  if (d.size() < (apart > 1 ? few : 1)) return 0;
  std::nth_element(d.begin(), d.begin() + d.size() / 2, d.end());
  return d[d.size() / 2] / (0.6745 * std::sqrt(20.0));
}

double noise_of_digits(const std::vector<double> &values) {
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
  return in_steps ? step / std::sqrt(12.0) : 0;
}

} // namespace rimpact::calibration

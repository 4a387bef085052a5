#include "calibration/data/series.h"
#include <algorithm>

namespace rimpact::calibration {

std::size_t interval_of(const std::vector<double> &times, double t) {
  if (times.size() < 2) return 0;
  const auto after = std::upper_bound(times.begin(), times.end(), t);
  const std::size_t index = after == times.begin() ? 0 : static_cast<std::size_t>(after - times.begin()) - 1;
  return std::min(index, times.size() - 2);
}

double linear_at(const std::vector<double> &times, const std::vector<double> &values, double t) {
  if (t <= times.front()) return values.front();
  if (t >= times.back()) return values.back();
  const std::size_t i = interval_of(times, t);
  const double share = (t - times[i]) / (times[i + 1] - times[i]);
  return values[i] + share * (values[i + 1] - values[i]);
}

double hermite_at(const std::vector<double> &times, const std::vector<double> &values, const std::vector<double> &rates,
                  double t) {
  if (t <= times.front()) return values.front();
  if (t >= times.back()) return values.back();
  const std::size_t i = interval_of(times, t);
  const double h = times[i + 1] - times[i], s = (t - times[i]) / h;
  const double a = 1 - s;
  return values[i] * a * a * (1 + 2 * s) + values[i + 1] * s * s * (3 - 2 * s) +
         h * (rates[i] * s * a * a - rates[i + 1] * s * s * a);
}

namespace {

/// Lagrange's polynomial through samples first..last.
double through(const std::vector<double> &times, const std::vector<double> &values, std::size_t first, std::size_t last,
               double t) {
  double sum = 0;
  for (std::size_t j = first; j <= last; ++j) {
    double basis = 1;
    for (std::size_t k = first; k <= last; ++k)
      if (k != j) basis *= (t - times[k]) / (times[j] - times[k]);
    sum += basis * values[j];
  }
  return sum;
}

} // namespace

double pulse_at(const std::vector<double> &times, const std::vector<double> &values, double t) {
  if (t < times.front() || t > times.back()) return 0;
  const std::size_t i = interval_of(times, t);
  const double begin = values[i], end = values[i + 1];
  if (begin == 0 && end == 0) return 0;
  // the window of up to four samples around [i, i+1] that goes on inside the pulse
  std::size_t first = i, last = i + 1;
  while (last - first < 3) {
    const bool left = first > 0 && values[first] != 0 && values[first - 1] != 0 && times[first] > times[first - 1];
    const bool right =
        last + 1 < times.size() && values[last] != 0 && values[last + 1] != 0 && times[last + 1] > times[last];
    if (!left && !right) break;
    const bool prefer_left = left && (!right || i - first < last - i - 1);
    prefer_left ? --first : ++last;
  }
  const double value = through(times, values, first, last, t);
  // between its end and the first sample inside, a pulse rises or falls: a coarse one must not overshoot
  return begin == 0 || end == 0 ? std::clamp(value, std::min(begin, end), std::max(begin, end)) : value;
}

std::vector<double> differentiate(const std::vector<double> &times, const std::vector<double> &values) {
  const std::size_t n = times.size();
  std::vector<double> rates(n, 0.0);
  // secants, NaN-free across jumps: an interval of no length has none
  const auto length = [&](std::size_t i) { return i + 1 < n ? times[i + 1] - times[i] : 0.0; };
  const auto secant = [&](std::size_t i) { return (values[i + 1] - values[i]) / length(i); };
  const auto one_sided = [&](std::size_t near, bool has_next, std::size_t next) {
    if (!has_next || !(length(next) > 0)) return secant(near);
    return secant(near) + (secant(near) - secant(next)) * length(near) / (length(near) + length(next));
  };
  for (std::size_t i = 0; i < n; ++i) {
    const double left = i > 0 ? length(i - 1) : 0, right = length(i);
    if (left > 0 && right > 0)
      rates[i] = (secant(i - 1) * right + secant(i) * left) / (left + right);
    else if (right > 0)
      rates[i] = one_sided(i, true, i + 1);
    else if (left > 0)
      rates[i] = one_sided(i - 1, i > 1, i - 2);
  }
  return rates;
}

} // namespace rimpact::calibration

#include "calibration/series.h"
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

double hermite_at(const std::vector<double> &times, const std::vector<double> &values,
                  const std::vector<double> &rates, double t) {
  if (t <= times.front()) return values.front();
  if (t >= times.back()) return values.back();
  const std::size_t i = interval_of(times, t);
  const double h = times[i + 1] - times[i], s = (t - times[i]) / h;
  const double a = 1 - s;
  return values[i] * a * a * (1 + 2 * s) + values[i + 1] * s * s * (3 - 2 * s) +
         h * (rates[i] * s * a * a - rates[i + 1] * s * s * a);
}

double pulse_at(const std::vector<double> &times, const std::vector<double> &values, double t) {
  if (t < times.front() || t > times.back()) return 0;
  const std::size_t i = interval_of(times, t);
  if (values[i] == 0) return t == times[i + 1] ? values[i + 1] : 0;
  if (values[i + 1] == 0) return t == times[i] ? values[i] : 0;
  // the window of up to four samples around [i, i+1] that stays inside the pulse
  const auto usable = [&](std::size_t from, std::size_t to) {
    return values[from] != 0 && (from + 1 != to || times[to] > times[from]);
  };
  std::size_t first = i, last = i + 1;
  while (last - first < 3) {
    const bool left = first > 0 && usable(first - 1, first);
    const bool right = last + 1 < times.size() && values[last + 1] != 0 && times[last + 1] > times[last];
    if (!left && !right) break;
    const bool prefer_left = left && (!right || i - first < last - i - 1);
    prefer_left ? --first : ++last;
  }
  double sum = 0;
  for (std::size_t j = first; j <= last; ++j) {
    double basis = 1;
    for (std::size_t k = first; k <= last; ++k)
      if (k != j) basis *= (t - times[k]) / (times[j] - times[k]);
    sum += basis * values[j];
  }
  return sum;
}

std::vector<double> differentiate(const std::vector<double> &times, const std::vector<double> &values) {
  const std::size_t n = times.size();
  std::vector<double> rates(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const bool left = i > 0 && times[i] > times[i - 1], right = i + 1 < n && times[i + 1] > times[i];
    const double hl = left ? times[i] - times[i - 1] : 0, hr = right ? times[i + 1] - times[i] : 0;
    const double sl = left ? (values[i] - values[i - 1]) / hl : 0;
    const double sr = right ? (values[i + 1] - values[i]) / hr : 0;
    if (left && right)
      rates[i] = (sl * hr + sr * hl) / (hl + hr);
    else
      rates[i] = left ? sl : sr;
  }
  return rates;
}

} // namespace rimpact::calibration

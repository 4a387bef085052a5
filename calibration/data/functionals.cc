#include "calibration/data/functionals.h"
#include "calibration/data/measured_record.h"
#include <algorithm>
#include <Eigen/Dense>

namespace rimpact::calibration {

namespace {

constexpr double around_peak = 0.8;      ///< of the largest smoothed value
constexpr Eigen::Index for_quartic = 10; ///< samples

} // namespace

Functional peak_functional(const std::vector<double> &times, const std::vector<double> &values,
                           const std::vector<double> &smooth) {
  const auto top = std::max_element(smooth.begin(), smooth.end());
  if (top == smooth.end() || *top <= 0) return {};
  std::size_t first = static_cast<std::size_t>(top - smooth.begin()), last = first;
  while (first > 0 && smooth[first - 1] >= around_peak * *top) --first;
  while (last + 1 < smooth.size() && smooth[last + 1] >= around_peak * *top) ++last;
  const auto n = static_cast<Eigen::Index>(last - first + 1);
  if (n < 3) return {};
  const Eigen::Index columns = n >= for_quartic ? 5 : 3;
  const double middle = 0.5 * (times[first] + times[last]), half = 0.5 * (times[last] - times[first]);
  const auto powers = [&](double s) {
    Eigen::RowVectorXd row(columns);
    row(0) = 1;
    for (Eigen::Index k = 1; k < columns; ++k) row(k) = row(k - 1) * s;
    return row;
  };
  Eigen::MatrixXd A(n, columns);
  for (Eigen::Index i = 0; i < n; ++i) A.row(i) = powers((times[first + i] - middle) / half);
  const Eigen::MatrixXd reading = (A.transpose() * A).ldlt().solve(A.transpose()); // coefficients from samples
  const Eigen::VectorXd c = reading * Eigen::Map<const Eigen::VectorXd>(values.data() + first, n);
  double best = 0, largest = powers(0).dot(c);
  for (int i = -50; i <= 50; ++i) // within half of the samples: at their ends a quartic knows least
    if (const double value = powers(0.01 * i).dot(c); value > largest) largest = value, best = 0.01 * i;
  const Eigen::RowVectorXd weights = powers(best) * reading;
  return {first, {weights.data(), weights.data() + n}};
}

Functional slope_functional(const std::vector<double> &times, std::size_t first, std::size_t last, double sign) {
  if (last + 1 < first + shortest_flight) return {};
  const double n = static_cast<double>(last - first + 1);
  double middle = 0, square = 0;
  for (std::size_t i = first; i <= last; ++i) middle += times[i] / n;
  for (std::size_t i = first; i <= last; ++i) square += (times[i] - middle) * (times[i] - middle);
  Functional slope{first, {}};
  for (std::size_t i = first; i <= last; ++i) slope.weights.push_back(sign * (times[i] - middle) / square);
  return slope;
}

void smooth_rates(const std::vector<double> &times, const std::vector<double> &values, std::size_t first,
                  std::size_t last, std::vector<double> &rates) {
  constexpr double reach = 2.5e-3;
  constexpr std::size_t least = 3;
  for (std::size_t i = first; i <= last; ++i) {
    std::size_t from = i, to = i;
    while (from > first && (i - from < least || times[i] - times[from - 1] <= reach)) --from;
    while (to < last && (to - i < least || times[to + 1] - times[i] <= reach)) ++to;
    const Functional slope = slope_functional(times, from, to, 1);
    rates[i] = slope.weights.empty() ? 0 : slope.of(values);
  }
}

double variance_gain(const Functional &functional) {
  double sum = 0;
  for (const double w : functional.weights) sum += w * w;
  return sum;
}

} // namespace rimpact::calibration

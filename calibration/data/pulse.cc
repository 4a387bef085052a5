#include "calibration/data/pulse.h"
#include <algorithm>
#include <Eigen/QR>

namespace rimpact::calibration {

namespace {

constexpr int degree = 4;
constexpr double share = 0.8; ///< of the largest sample
using Coefficients = Eigen::Matrix<double, degree + 1, 1>;

double polynomial(const Coefficients &c, double s) {
  double value = 0;
  for (int k = degree; k >= 0; --k) value = value * s + c(k);
  return value;
}

/// Largest value on [-1, 1], refined by a parabola through the best of a fine grid and its neighbours.
double largest_value(const Coefficients &c) {
  constexpr int n = 64;
  int best = 0;
  double top = polynomial(c, -1);
  for (int i = 1; i <= n; ++i) {
    const double value = polynomial(c, -1 + 2.0 * i / n);
    if (value > top) top = value, best = i;
  }
  if (best == 0 || best == n) return top;
  double low = -1 + 2.0 * (best - 1) / n, high = -1 + 2.0 * (best + 1) / n;
  for (int iteration = 0; iteration < 40; ++iteration) { // golden section
    const double third = 0.381966 * (high - low), a = low + third, b = high - third;
    polynomial(c, a) > polynomial(c, b) ? high = b : low = a;
  }
  return polynomial(c, 0.5 * (low + high));
}

} // namespace

double smooth_peak(const std::vector<double> &times, const std::vector<double> &force) {
  const auto top = std::max_element(force.begin(), force.end());
  if (top == force.end() || *top <= 0) return 0;
  std::size_t first = static_cast<std::size_t>(top - force.begin()), last = first;
  while (first > 0 && force[first - 1] >= share * *top) --first;
  while (last + 1 < force.size() && force[last + 1] >= share * *top) ++last;
  const auto n = static_cast<Eigen::Index>(last - first + 1);
  if (n < degree + 2 || times[last] <= times[first]) return *top;

  Eigen::Matrix<double, Eigen::Dynamic, degree + 1> A(n, degree + 1);
  Eigen::VectorXd b(n);
  const double middle = 0.5 * (times[first] + times[last]), half = 0.5 * (times[last] - times[first]);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double s = (times[first + i] - middle) / half,
                 above = std::clamp((force[first + i] / *top - share) / 0.1, 0.0, 1.0);
    const double weight = above * above * (3 - 2 * above); // a sample that comes in by a hair counts for one
    A(i, 0) = weight;
    for (int k = 1; k <= degree; ++k) A(i, k) = A(i, k - 1) * s;
    b(i) = weight * force[first + i];
  }
  const Coefficients c = A.householderQr().solve(b);
  return largest_value(c);
}

} // namespace rimpact::calibration

#include "calibration/export/rider.h"
#include "calibration/export/golden_section.h"

#include <algorithm>
#include <cmath>

namespace rimpact::calibration {
namespace {

constexpr double least_ratio = 0.05, nearly_sphere = 0.95; ///< a lever whose one arm is hardly there is of no use

struct Meridian {
  const std::vector<double> &travel, &slope;

  /// Of half-width a: least squares, at most a sphere's.
  Rider of_width(double a) const {
    double product = 0, square = 0;
    for (std::size_t i = 0; i < travel.size(); ++i) {
      const double unit = travel[i] / std::sqrt(a * a - travel[i] * travel[i]);
      product += unit * slope[i], square += unit * unit;
    }
    return {a, std::clamp(product / square, least_ratio, 1.0)};
  }
  double misfit(const Rider &rider) const {
    double sum = 0;
    for (std::size_t i = 0; i < travel.size(); ++i) sum += std::pow(rider.slope(travel[i]) - slope[i], 2);
    return sum;
  }
  /// The best of `of` over ln a: on a grid, then by golden section between its neighbours.
  Rider best(const std::function<Rider(double a)> &of) const {
    const auto cost = [&](double log_a) { return misfit(of(std::exp(log_a))); };
    const double low = std::log(1.02 * travel.back()), high = std::log(100 * travel.back());
    constexpr int n_grid = 200;
    const double step = (high - low) / n_grid;
    double least = low;
    for (int i = 1; i <= n_grid; ++i)
      if (cost(low + i * step) < cost(least)) least = low + i * step;
    return of(std::exp(golden_section(std::max(low, least - step), least + step, cost)));
  }
};

} // namespace

double Rider::slope(double r) const {
  return ratio * r / std::sqrt(half_width * half_width - r * r);
}

double Rider::curvature(double r) const {
  const double left = half_width * half_width - r * r;
  return ratio * half_width * half_width / (left * std::sqrt(left));
}

Rider rider_of(const std::vector<double> &travel, const std::vector<double> &slope) {
  const Meridian dish{travel, slope};
  const Rider any = dish.best([&](double a) { return dish.of_width(a); });
  return any.ratio > nearly_sphere ? dish.best([](double a) { return Rider{a, 1}; }) : any;
}

double mean_to(double capacity, const std::function<double(double r)> &function) {
  constexpr int n = 400;
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += function(capacity * (i + 0.5) / n);
  return sum / n;
}

RidingFriction riding_friction(const Rider &rider, double capacity,
                               const std::function<double(double r)> &per_reaction) {
  const auto slope = [&](double r) { return rider.slope(r); };
  const double p = mean_to(capacity, slope), f = mean_to(capacity, per_reaction);
  const double square = mean_to(capacity, [&](double r) { return slope(r) * slope(r); });
  const double product = mean_to(capacity, [&](double r) { return slope(r) * per_reaction(r); });
  const double spread = square - p * p, rises = spread > 0 ? std::max(0.0, (product - p * f) / spread) : 0.0;
  return {std::max(0.0, f - rises * p), rises};
}

} // namespace rimpact::calibration

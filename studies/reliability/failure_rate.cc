#include "studies/reliability/failure_rate.h"
#include "io/files/error.h"
#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace rimpact::reliability {
namespace {

void require_growing(const std::vector<double> &values, const char *what) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]) || values[i] <= (i == 0 ? 0 : values[i - 1]))
      throw InputError(fmt::format("{}: {} does not exceed {}", what, values[i], i == 0 ? 0 : values[i - 1]));
}

/// Between two intensities on one line of the hazard, over u = ln x: |d lambda| = slope x lambda du.
double share_on_line(const HazardCurve &hazard, const Fragility &fragility, double low, double high) {
  const double slope = hazard.slope(std::sqrt(low * high));
  const auto integrand = [&](double u) { return fragility(std::exp(u)) * slope * hazard.rate(std::exp(u)); };
  return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, std::log(low), std::log(high), 12,
                                                                       1e-11);
}

double share(const HazardCurve &hazard, const Fragility &fragility, double low, double high) {
  double sum = 0, from = low;
  for (const auto &point : hazard.points()) {
    if (point.intensity <= from || point.intensity >= high) continue;
    sum += share_on_line(hazard, fragility, from, point.intensity);
    from = point.intensity;
  }
  return sum + share_on_line(hazard, fragility, from, high);
}

} // namespace

Fragility interpolated(std::vector<FragilityPoint> points) {
  if (points.empty()) throw InputError("a fragility curve needs at least one level");
  std::vector<double> intensities;
  for (const auto &p : points) {
    intensities.push_back(p.intensity);
    if (!(p.probability >= 0 && p.probability <= 1))
      throw InputError(fmt::format("probability {} at intensity {} is not in [0, 1]", p.probability, p.intensity));
  }
  require_growing(intensities, "intensities of a fragility curve");
  return [points = std::move(points)](double x) {
    const auto above = std::upper_bound(points.begin(), points.end(), x,
                                        [](double value, const FragilityPoint &p) { return value < p.intensity; });
    if (above == points.begin()) return 0.0;
    const auto &a = *(above - 1);
    if (above == points.end()) return a.probability;
    const double along = std::log(x / a.intensity) / std::log(above->intensity / a.intensity);
    return a.probability + along * (above->probability - a.probability);
  };
}

FailureRate failure_rate(const HazardCurve &hazard, const Fragility &fragility, const std::vector<double> &edges) {
  if (edges.size() < 2)
    throw InputError(fmt::format("a rate needs at least 2 intensities as edges, not {}", edges.size()));
  require_growing(edges, "edges of a rate");
  FailureRate result;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    result.shares.push_back({edges[i], edges[i + 1], share(hazard, fragility, edges[i], edges[i + 1])});
    result.rate += result.shares.back().rate;
  }
  result.above = fragility(edges.back()) * hazard.rate(edges.back());
  result.rate += result.above;
  return result;
}

double probability_in(double years, double rate) {
  if (!(years >= 0)) throw InputError(fmt::format("{} years are not >= 0", years));
  if (!(rate >= 0)) throw InputError(fmt::format("rate {} is not >= 0", rate));
  return -std::expm1(-rate * years);
}

} // namespace rimpact::reliability

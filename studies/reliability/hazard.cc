#include "studies/reliability/hazard.h"
#include "io/files/error.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace rimpact::reliability {
namespace {

constexpr double steepest = 100; // seismic hazard falls by powers of 1 to 10

bool positive(double value) {
  return std::isfinite(value) && value > 0;
}

void require_growth(const char *what, int number, double before, double after) {
  if (!(after > before))
    throw InputError(fmt::format("the hazard curve is not monotone: {} {} of point {} does not exceed {} of point {}",
                                 what, after, number + 1, before, number));
}

} // namespace

HazardCurve::HazardCurve(std::vector<HazardPoint> points) : points_(std::move(points)) {
  if (points_.size() < 2)
    throw InputError(fmt::format("a hazard curve needs at least 2 points, not {}", points_.size()));
  for (const auto &p : points_)
    if (!positive(p.intensity) || !positive(p.return_period_years))
      throw InputError(fmt::format("hazard point ({}, {} years): both numbers must be finite and > 0", p.intensity,
                                   p.return_period_years));
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    const auto &a = points_[i], &b = points_[i + 1];
    require_growth("intensity", static_cast<int>(i) + 1, a.intensity, b.intensity);
    require_growth("return period", static_cast<int>(i) + 1, a.return_period_years, b.return_period_years);
    slopes_.push_back(std::log(b.return_period_years / a.return_period_years) / std::log(b.intensity / a.intensity));
    if (!(slopes_.back() <= steepest))
      throw InputError(fmt::format("the hazard curve falls as intensity^-{:.3g} between points {} and {}; {:g} is the "
                                   "steepest a ground can have",
                                   slopes_.back(), i + 1, i + 2, steepest));
  }
}

std::size_t HazardCurve::line_of(double intensity) const {
  const auto above = std::upper_bound(points_.begin() + 1, points_.end() - 1, intensity,
                                      [](double x, const HazardPoint &p) { return x < p.intensity; });
  return static_cast<std::size_t>(above - points_.begin()) - 1;
}

double HazardCurve::slope(double intensity) const {
  return slopes_[line_of(intensity)];
}

double HazardCurve::rate(double intensity) const {
  if (!(intensity > 0)) throw InputError(fmt::format("intensity {} is not > 0", intensity));
  const std::size_t line = line_of(intensity);
  return std::pow(intensity / points_[line].intensity, -slopes_[line]) / points_[line].return_period_years;
}

} // namespace rimpact::reliability

#include "calibration/studies/vary_study.h"

#include "calibration/data/series.h"
#include "io/files/error.h"
#include "responses/crossing.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace rimpact::calibration {
namespace {

/// Lagrange's parabola through three points.
double parabola(const std::array<double, 3> &x, const std::array<double, 3> &y, double at) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double weight = y[i];
    for (std::size_t j = 0; j < 3; ++j)
      if (j != i) weight *= (at - x[j]) / (x[i] - x[j]);
    sum += weight;
  }
  return sum;
}

SeverityTable table_of(const laws::RimCurve &curve, const reduced::RimCurveFile &file) {
  constexpr int n_steps = 80; // straight lines between them are within 1e-3 of the curve
  const double most = std::sqrt(2 * curve.work(curve.range()));
  SeverityTable table;
  for (int i = 0; i <= n_steps; ++i) {
    const double severity = most * i / n_steps,
                 depth = i == 0 ? 0 : std::min(curve.depth_of(severity * severity / 2), curve.range());
    table.severity.push_back(severity);
    table.depth.push_back(depth);
    table.peak_force.push_back(curve.loading(depth).force);
    table.rebound.push_back(i == 0 ? 0 : std::sqrt(2 * curve.returned(depth)));
    if (!file.strain.strain.empty())
      table.strain.push_back(linear_at(file.strain.penetration, file.strain.strain, depth));
    if (!file.foot.use.empty()) table.foot_use.push_back(linear_at(file.foot.penetration, file.foot.use, depth));
  }
  return table;
}

} // namespace

std::string in_words(const std::vector<double> &at, const VaryQuestion &question) {
  std::string text;
  for (std::size_t j = 0; j < at.size(); ++j)
    text += fmt::format("{}{} = {:g}", j == 0 ? "" : ", ", question.keys[j].key, at[j]);
  return text;
}

const std::vector<std::string> &vary_outputs() {
  static const std::vector<std::string> names{"peak_kN", "depth_mm", "rebound_m_per_s", "strain", "rim_foot_use"};
  return names;
}

double VaryPoint::output(std::size_t k) const {
  constexpr double kilo = 1e-3, milli = 1e3;
  switch (k) {
  case 0:
    return kilo * peak_force;
  case 1:
    return milli * depth;
  case 2:
    return rebound;
  case 3:
    return strain.value_or(std::numeric_limits<double>::quiet_NaN());
  default:
    return foot_use.value_or(std::numeric_limits<double>::quiet_NaN());
  }
}

VaryPoint vary_point(const reduced::RimCurveFile &file, const VaryQuestion &question) {
  const laws::RimCurve curve(file.held);
  const double work = question.mass / 2 * question.speed * question.speed;
  VaryPoint point{};
  point.fastest = std::sqrt(2 * curve.work(curve.range()) / question.mass);
  if (!(point.fastest >= question.speed))
    throw DataError(fmt::format("the curve stops {:.3f} m/s, {:g} m/s is asked for", point.fastest, question.speed));
  point.depth = curve.depth_of(work);
  point.peak_force = curve.loading(point.depth).force;
  point.rebound = std::sqrt(2 * curve.returned(point.depth) / question.mass);
  point.table = table_of(curve, file);
  const auto speed_where = [&](const std::vector<double> &d, const std::vector<double> &value,
                               double limit) -> std::optional<double> {
    const auto passed = first_crossing(value, limit);
    if (!passed || passed->of(d) > curve.range()) return {};
    return std::sqrt(2 * curve.work(passed->of(d)) / question.mass);
  };
  if (!file.foot.use.empty()) {
    point.foot_use = linear_at(file.foot.penetration, file.foot.use, point.depth);
    point.foot_goes_at = speed_where(file.foot.penetration, file.foot.use, 1.0);
  }
  if (file.strain.strain.empty()) return point;
  point.strain = linear_at(file.strain.penetration, file.strain.strain, point.depth);
  if (question.strain_limit)
    point.speed_at_limit = speed_where(file.strain.penetration, file.strain.strain, *question.strain_limit);
  return point;
}

Interpolated interpolated(const std::vector<VaryPoint> &points, std::size_t k, double x) {
  const auto value = [&](std::size_t i) { return points[i].output(k); };
  const auto near = std::min_element(points.begin(), points.end(), [x](const auto &a, const auto &b) {
    return std::abs(a.at[0] - x) < std::abs(b.at[0] - x);
  });
  constexpr double same = 1e-9;
  if (std::abs(near->at[0] - x) <= same * std::abs(x)) return {near->output(k), 0.0};
  bool logarithmic = true;
  for (std::size_t i = 0; i < points.size(); ++i) logarithmic &= value(i) > 0;
  const auto scaled = [&](double y) { return logarithmic ? std::log(y) : y; };
  const auto back = [&](double y) { return logarithmic ? std::exp(y) : y; };
  const auto right = std::clamp<std::size_t>(
      std::upper_bound(points.begin(), points.end(), x, [](double at, const auto &p) { return at < p.at[0]; }) -
          points.begin(),
      1, points.size() - 1);
  const std::size_t left = right - 1;
  const double share = std::log(x / points[left].at[0]) / std::log(points[right].at[0] / points[left].at[0]);
  const double straight = back(scaled(value(left)) + share * (scaled(value(right)) - scaled(value(left))));
  if (points.size() < 3) return {straight, {}};
  std::size_t first = left;
  if (right + 1 == points.size() || (left > 0 && x - points[left - 1].at[0] < points[right + 1].at[0] - x)) --first;
  std::array<double, 3> xs{}, ys{};
  for (std::size_t i = 0; i < 3; ++i) xs[i] = std::log(points[first + i].at[0]), ys[i] = scaled(value(first + i));
  const double curved = back(parabola(xs, ys, std::log(x)));
  return {curved, std::abs(straight / curved - 1)};
}

} // namespace rimpact::calibration

#include "laws/impact/rim_curve.h"

#include <math.h> // Boost 1.74's pchip calls isnan without std::

#include <boost/math/interpolators/pchip.hpp>

#include "io/files/error.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::laws {
namespace {

using Pchip = boost::math::interpolators::pchip<std::vector<double>>;
constexpr double same_point = 1e-6; ///< of the force: an unloading begins on the loading

Pchip through(std::vector<double> x, std::vector<double> y) {
  return {std::move(x), std::move(y)};
}

void require_samples(const CurveSamples &s, double sense, const std::string &name) {
  if (s.penetration.size() != s.force.size() || s.penetration.size() < 4)
    throw InputError(
        fmt::format("{} has {} penetrations and {} forces; at least 4 of each, as many of both, are needed", name,
                    s.penetration.size(), s.force.size()));
  for (std::size_t i = 0; i < s.force.size(); ++i) {
    if (!std::isfinite(s.penetration[i]) || !std::isfinite(s.force[i]))
      throw InputError(fmt::format("{}: sample {} is not finite", name, i + 1));
    if (i > 0 && !(sense * (s.penetration[i] - s.penetration[i - 1]) > 0))
      throw InputError(fmt::format("{}: penetration {:g} m follows {:g} m; it must {}", name, s.penetration[i],
                                   s.penetration[i - 1], sense > 0 ? "rise" : "fall"));
  }
}

/// One pushed unloading over the share of its returned way.
struct Branch {
  double deepest, top, length; ///< [m], [N], [m]
  Pchip shape;                 ///< force over top, of x in 0..1
  double area;                 ///< of the shape over x
};

/// Area below an interpolant between two of its nodes: exact for its cubics (Simpson).
template <class Curve> double area(const Curve &curve, double a, double b) {
  return (b - a) / 6 * (curve(a) + 4 * curve((a + b) / 2) + curve(b));
}

Branch branch_of(const CurveSamples &s) {
  const std::size_t n = s.force.size();
  const double length = s.penetration.front() - s.penetration.back();
  std::vector<double> x(n), f(n);
  for (std::size_t i = 0; i < n; ++i)
    x[i] = (s.penetration.front() - s.penetration[i]) / length, f[i] = s.force[i] / s.force.front();
  x.back() = 1, f.back() = 0;
  Branch branch{s.penetration.front(), s.force.front(), length, through(x, f), 0};
  for (std::size_t i = 1; i < n; ++i) branch.area += area(branch.shape, x[i - 1], x[i]);
  return branch;
}

/// L / D over D from 1 at 0; of at least four points, as pchip needs them.
Pchip returned_share(const std::vector<Branch> &branches) {
  std::vector<double> depth{0}, share{1};
  for (const Branch &b : branches) {
    const double before = depth.back(), was = share.back(), now = b.length / b.deepest;
    for (int i = 1; branches.size() < 3 && i < 3; ++i)
      depth.push_back(before + (b.deepest - before) * i / 3), share.push_back(was + (now - was) * i / 3);
    depth.push_back(b.deepest), share.push_back(now);
  }
  return through(depth, share);
}

} // namespace

struct RimCurve::Interpolants {
  Pchip loading;
  std::vector<double> work; ///< at the loading's samples [J]
  std::vector<Branch> branches;
  Pchip share;

  /// The shape at D is (1 - weight) times that of `below`, plus `weight` times that of `above`.
  struct Between {
    const Branch *below, *above;
    double weight;
  };
  Between between(double deepest) const {
    const auto above =
        std::find_if(branches.begin(), branches.end(), [&](const Branch &b) { return b.deepest >= deepest; });
    if (above == branches.end()) return {&branches.back(), &branches.back(), 0};
    if (above == branches.begin()) return {&*above, &*above, 0};
    const Branch &below = *(above - 1);
    return {&below, &*above, (deepest - below.deepest) / (above->deepest - below.deepest)};
  }
  double length(double deepest) const { return deepest * share(std::clamp(deepest, 0.0, branches.back().deepest)); }
};

RimCurve::RimCurve(CurvePath path) : path_(std::move(path)) {
  const CurveSamples &load = path_.loading;
  require_samples(load, 1, "the loading");
  if (load.penetration.front() != 0 || load.force.front() != 0)
    throw InputError("the loading does not begin at penetration 0 and force 0");
  if (!(load.force[1] > 0))
    throw InputError(fmt::format("the loading's first force {:g} N must be > 0", load.force[1]));
  if (path_.unloading.empty()) throw InputError("there is no unloading");
  const Pchip loading = through(load.penetration, load.force);
  std::vector<double> work{0};
  for (std::size_t i = 1; i < load.force.size(); ++i)
    work.push_back(work.back() + area(loading, load.penetration[i - 1], load.penetration[i]));
  std::vector<Branch> branches;
  for (std::size_t k = 0; k < path_.unloading.size(); ++k) {
    const CurveSamples &back = path_.unloading[k];
    const std::string name = fmt::format("unloading {}", k + 1);
    require_samples(back, -1, name);
    const double D = back.penetration.front(), open = back.penetration.back();
    if (!(D <= load.penetration.back()) || !(open >= 0) || (k > 0 && !(D > branches.back().deepest)))
      throw InputError(fmt::format("{} goes from {:g} to {:g} m; it must begin deeper than the one before, within the "
                                   "loading's {:g} m, and end at or above 0",
                                   name, D, open, load.penetration.back()));
    if (!(back.force.front() > 0) || std::abs(loading(D) / back.force.front() - 1) > same_point)
      throw InputError(
          fmt::format("{} begins with {:g} N, the loading has {:g} N there", name, back.force.front(), loading(D)));
    if (back.force.back() != 0)
      throw InputError(fmt::format("{} ends with {:g} N; it must end with 0", name, back.force.back()));
    branches.push_back(branch_of(back));
  }
  Pchip share = returned_share(branches);
  by_ = std::make_unique<Interpolants>(Interpolants{loading, std::move(work), std::move(branches), std::move(share)});
}
RimCurve::~RimCurve() = default;
RimCurve::RimCurve(RimCurve &&) noexcept = default;

RimCurve::Force RimCurve::loading(double d) const {
  const double end = path_.loading.penetration.back(), at = std::clamp(d, 0.0, end), slope = by_->loading.prime(at);
  return {by_->loading(at) + slope * (d - at), slope};
}

RimCurve::Force RimCurve::unloading(double d, double deepest) const {
  const double top = loading(deepest).force, length = by_->length(deepest), x = (deepest - d) / length;
  if (x >= 1) return {top * (1 - x), top / length};
  const auto [below, above, weight] = by_->between(deepest);
  const double at = std::max(0.0, x);
  const double f = (1 - weight) * below->shape(at) + weight * above->shape(at),
               slope = (1 - weight) * below->shape.prime(at) + weight * above->shape.prime(at);
  return {top * f, -top * slope / length};
}

double RimCurve::range() const {
  return by_->branches.back().deepest;
}

double RimCurve::work(double d) const {
  const auto &at = path_.loading.penetration;
  const std::size_t i =
      std::clamp<std::size_t>(std::upper_bound(at.begin(), at.end(), d) - at.begin(), 1, at.size() - 1) - 1;
  return by_->work[i] + area([&](double x) { return loading(x).force; }, at[i], d);
}

double RimCurve::returned(double deepest) const {
  const auto [below, above, weight] = by_->between(deepest);
  return loading(deepest).force * by_->length(deepest) * ((1 - weight) * below->area + weight * above->area);
}

double RimCurve::residual(double deepest) const {
  return deepest - by_->length(deepest);
}

double RimCurve::depth_of(double wanted) const {
  double low = 0, high = path_.loading.penetration.back();
  for (int i = 0; i < 60; ++i) (work((low + high) / 2) < wanted ? low : high) = (low + high) / 2;
  return high;
}

double RimCurve::left_out_rebound() const {
  double largest = 0;
  for (std::size_t k = 1; k + 1 < path_.unloading.size(); ++k) {
    CurvePath without = path_;
    without.unloading.erase(without.unloading.begin() + static_cast<long>(k));
    const double deepest = by_->branches[k].deepest;
    largest = std::max(largest, std::abs(std::sqrt(RimCurve(without).returned(deepest) / returned(deepest)) - 1));
  }
  return largest;
}

} // namespace rimpact::laws

#include "studies/reliability/binomial_fit.h"
#include "studies/reliability/normal.h"
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

namespace rimpact::reliability {
namespace {

/// p, 1 - p and dp/d(predictor), each with all its digits.
struct Curve {
  double p, q, slope;
};
Curve curve(Link link, double predictor) {
  const double z = std::clamp(predictor, -farthest_score, farthest_score);
  if (link == Link::logit) {
    const double p = 1 / (1 + std::exp(-z)), q = 1 / (1 + std::exp(z));
    return {p, q, p * q};
  }
  return {normal_probability(z), normal_probability(-z), normal_density(z)};
}

double predictor_of(Link link, double share) {
  if (link == Link::logit) return std::log(share / (1 - share));
  return standard_score(share);
}

double log_likelihood(Link link, const std::vector<ShareAt> &levels, double a, double b) {
  double sum = 0;
  for (const auto &level : levels) {
    const Curve c = curve(link, a + b * std::log(level.intensity));
    sum += level.weight * (level.share * std::log(c.p) + (1 - level.share) * std::log(c.q));
  }
  return sum;
}

struct Step {
  double a, b;
};
/// Of Fisher's scoring.
Step scoring_step(Link link, const std::vector<ShareAt> &levels, double a, double b) {
  double aa = 0, ab = 0, bb = 0, ga = 0, gb = 0;
  for (const auto &level : levels) {
    const double u = std::log(level.intensity);
    const Curve c = curve(link, a + b * u);
    const double w = level.weight * c.slope / (c.p * c.q), residual = w * (level.share - c.p), info = w * c.slope;
    ga += residual, gb += residual * u;
    aa += info, ab += info * u, bb += info * u * u;
  }
  const double determinant = aa * bb - ab * ab;
  return {(bb * ga - ab * gb) / determinant, (aa * gb - ab * ga) / determinant};
}

/// A line through the predictors of the shares between 0 and 1, by least squares.
Step start(Link link, const std::vector<ShareAt> &inner) {
  double n = 0, u = 0, z = 0, uu = 0, uz = 0;
  for (const auto &level : inner) {
    const double x = std::log(level.intensity),
                 y = std::clamp(predictor_of(link, level.share), -farthest_score, farthest_score);
    ++n, u += x, z += y, uu += x * x, uz += x * y;
  }
  const double b = (n * uz - u * z) / (n * uu - u * u);
  return {(z - b * u) / n, b};
}

} // namespace

double BinomialFit::at(double intensity) const {
  return curve(link, a + b * std::log(intensity)).p;
}

double BinomialFit::median() const {
  return std::exp(-a / b);
}

std::optional<BinomialFit> fit_binomial(const std::vector<ShareAt> &levels, Link link) {
  std::vector<ShareAt> inner, all = levels;
  double weight = 0;
  for (const auto &level : levels) weight += level.weight;
  for (auto &level : all) {
    level.weight /= weight;
    if (level.share > 1e-300 && level.share < 1 - 1e-16) inner.push_back(level);
  }
  if (inner.size() < 2) return std::nullopt;
  auto [a, b] = start(link, inner);
  double likelihood = log_likelihood(link, all, a, b);
  constexpr int most_steps = 200;
  for (int i = 0; i < most_steps; ++i) {
    Step step = scoring_step(link, all, a, b);
    if (!std::isfinite(step.a) || !std::isfinite(step.b)) return std::nullopt;
    const double size = std::max(std::abs(step.a), std::abs(step.b)) / std::max({1.0, std::abs(a), std::abs(b)});
    double next = log_likelihood(link, all, a + step.a, b + step.b);
    for (int half = 0; half < 40 && next < likelihood - 1e-14 * std::abs(likelihood); ++half) {
      step.a /= 2, step.b /= 2;
      next = log_likelihood(link, all, a + step.a, b + step.b);
    }
    a += step.a, b += step.b, likelihood = next;
    if (size < 1e-14) break;
  }
  if (!(b > 0) || !std::isfinite(a) || !std::isfinite(b)) return std::nullopt;
  return BinomialFit{link, a, b};
}

double test_of_fit(const BinomialFit &fit, const std::vector<ShareAt> &levels) {
  if (levels.size() < 3) return 1;
  double sum = 0;
  for (const auto &level : levels) {
    const Curve c = curve(fit.link, fit.a + fit.b * std::log(level.intensity));
    sum += level.weight * std::pow(level.share - c.p, 2) / std::max(c.p * c.q, 1e-12);
  }
  const boost::math::chi_squared distribution(static_cast<double>(levels.size()) - 2);
  return boost::math::cdf(boost::math::complement(distribution, sum));
}

} // namespace rimpact::reliability

#include "calibration/fit/uncertainty.h"
#include "calibration/fit/noise_left.h"
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <stdexcept>

namespace rimpact::calibration {

namespace {

constexpr double both_sides_of_95 = 0.975;
/// A parameter whose 95 % interval reaches this share of its value to either side is not identified.
constexpr double vague = 0.5;
/// Condition (relative changes) beyond which the valley is called flat.
constexpr double flat_condition = 1e4;
/// Share of the bounds' range within which a value counts as standing at the bound.
constexpr double at_bound = 1e-6;
/// Of squared residuals: differences of interpolation and digits, in uncertainties.
constexpr double numerical = 1e-8;

/// What correlated residuals lose in independent observations, (1 + rho) / (1 - rho) for lag-one correlation rho, at
/// most their count.
double correlation_inflation(const Eigen::VectorXd &part) {
  const auto n = part.size();
  if (n <= 2) return 1;
  const double lag = part.head(n - 1).dot(part.tail(n - 1)) / part.squaredNorm();
  return lag > 0 ? std::min((1 + lag) / std::max(1 - lag, 1e-12), static_cast<double>(n)) : 1;
}

/// Variance of one residual of a group: stated (weight^2 / count) or, with its correlation, found,
/// whichever is larger.
double group_variance(const Group &group, const Eigen::VectorXd &r) {
  const Eigen::VectorXd part = r.segment(group.first, group.count);
  const double n = group.count, found = part.squaredNorm() / n, stated = group.weight * group.weight / n;
  return found <= stated ? stated : found * correlation_inflation(part);
}

/// Variance of a residual that the noise of the record does not explain, inflated as above: the law's form. None within
/// what noise does once in thousands of groups.
double beyond_noise(const Group &group, const NoiseLeft &noise, const Eigen::VectorXd &r) {
  const Eigen::VectorXd part = r.segment(group.first, group.count);
  const double found = part.squaredNorm() / group.count;
  return found <= noise.limit + numerical ? 0 : (found - noise.mean) * correlation_inflation(part);
}

/// Derivative of Huber's loss with respect to the squared norm s.
double huber_slope(double s, double scale) {
  return scale <= 0 || s <= scale * scale ? 1.0 : scale / std::sqrt(s);
}

Linearised linearised(const Problem &problem, const ResidualBlock &block, const Eigen::VectorXd &x,
                      const Eigen::VectorXd &nuisance, double robust_scale) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::VectorXd r(block.size());
  RowMajor J(block.size(), problem.n_parameters()), N(block.size(), block.n_nuisance());
  if (!problem.residuals(block, x.data(), nuisance.data(), r.data()) ||
      !problem.jacobian(block, x.data(), nuisance.data(), J.data()) ||
      (N.cols() > 0 && !problem.nuisance_jacobian(block, x.data(), nuisance.data(), N.data())))
    throw std::logic_error("the fitted values cannot be evaluated");
  const double weight = huber_slope(r.squaredNorm(), robust_scale);
  if (N.cols() == 0) return {&block, r, J, N, weight};
  const Eigen::MatrixXd normal = N.transpose() * N; // the start's own residuals make it regular
  return {&block, r, J - N * normal.ldlt().solve(N.transpose() * J), N, weight};
}

/// J^T V J of all impacts of one record by the noise of one of its channels.
struct NoiseShare {
  Eigen::MatrixXd filling;
  double freedom;
};
using NoiseShares = std::map<std::pair<const void *, Channel>, NoiseShare>;

void add_noise(NoiseShares &shares, const Linearised &part) {
  for (const Channel channel : {Channel::force, Channel::displacement}) {
    const Eigen::MatrixXd filling =
        part.weight * part.weight * part.J.transpose() * part.block->noise_times(part.J, channel);
    const auto [share, is_new] =
        shares.insert({{part.block->record(), channel}, {filling, part.block->freedom(channel)}});
    if (!is_new) share->second.filling += filling;
  }
}

/// Of the variances: what noise gives has the degrees of freedom that noise was found with, the rest is stated.
Eigen::VectorXd freedom_of(const Eigen::MatrixXd &covariance, const Eigen::MatrixXd &inverse,
                           const NoiseShares &shares) {
  Eigen::VectorXd loss = Eigen::VectorXd::Zero(covariance.rows());
  for (const auto &[origin, share] : shares) {
    const Eigen::MatrixXd variance = inverse * share.filling * inverse;
    loss += variance.diagonal().cwiseAbs2() / share.freedom;
  }
  return covariance.diagonal().cwiseAbs2().cwiseQuotient(loss);
}

/// The normal matrix in relative changes of the parameters.
double condition_of(const Problem &problem, const Eigen::VectorXd &x, const Eigen::MatrixXd &bread) {
  const int n = problem.n_parameters();
  Eigen::VectorXd relative(n);
  for (int i = 0; i < n; ++i) relative(i) = problem.per_relative_change(i, x(i));
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(relative.asDiagonal() * bread * relative.asDiagonal());
  const double least = svd.singularValues()(n - 1), most = svd.singularValues()(0);
  return most > 0 && least >= 1e-14 * most ? std::sqrt(most / least) : std::numeric_limits<double>::infinity();
}

double half_of_95(double freedom) {
  return boost::math::quantile(boost::math::students_t(freedom > 1 ? freedom : 1), both_sides_of_95);
}

} // namespace

Spread spread_at(const Problem &problem, const Eigen::VectorXd &x, const Nuisance &nuisance, double robust_scale) {
  const int n = problem.n_parameters();
  Eigen::MatrixXd bread = Eigen::MatrixXd::Zero(n, n), noise = bread, stated = bread, found = bread;
  Eigen::VectorXd gain = Eigen::VectorXd::Zero(n); // one error, common to all impacts
  Spread spread;
  std::vector<Linearised> parts;
  NoiseShares shares;
  for (std::size_t k = 0; k < problem.blocks().size(); ++k) {
    parts.push_back(linearised(problem, *problem.blocks()[k], x, nuisance[k], robust_scale));
    const Linearised &part = parts.back();
    bread += part.weight * part.J.transpose() * part.J;
    if (!part.block->measured()) continue;
    spread.measured = true;
    add_noise(shares, part);
    gain += part.weight * part.J.transpose() * part.block->gain_error();
  }
  spread.condition = condition_of(problem, x, bread);
  if (!std::isfinite(spread.condition)) {
    spread.covariance = Eigen::MatrixXd::Constant(n, n, std::numeric_limits<double>::infinity());
    spread.stated_covariance = spread.covariance, spread.freedom = spread.covariance.diagonal();
    return spread;
  }
  const Eigen::MatrixXd inverse = bread.inverse();
  for (const auto &[origin, share] : shares) noise += share.filling;
  const Eigen::MatrixXd by_noise = inverse * noise * inverse;
  for (const Linearised &part : parts) {
    const bool measured = part.block->measured();
    const auto left = measured ? noise_left(part, inverse, by_noise) : std::vector<NoiseLeft>();
    for (std::size_t g = 0; g < part.block->groups().size(); ++g) {
      const Group &group = part.block->groups()[g];
      const auto rows = part.J.middleRows(group.first, group.count);
      const Eigen::MatrixXd square = part.weight * part.weight * rows.transpose() * rows;
      const double excess = measured ? beyond_noise(group, left[g], part.r) : 0;
      spread.within_noise = spread.within_noise && excess == 0;
      found += (measured ? excess : group_variance(group, part.r)) * square;
      if (!measured) stated += group.weight * group.weight / group.count * square;
    }
  }
  const Eigen::MatrixXd common = noise + gain * gain.transpose();
  spread.covariance = inverse * (common + found) * inverse;
  spread.stated_covariance = inverse * (common + stated) * inverse;
  spread.freedom = freedom_of(spread.covariance, inverse, shares);
  return spread;
}

void judge(const Problem &problem, const Eigen::VectorXd &x, const Spread &spread, FitResult &result) {
  const int n = problem.n_parameters();
  result.condition = spread.condition;
  for (int i = 0; i < n; ++i) {
    const Parameter &p = problem.parameter(i);
    const double sd = std::sqrt(spread.covariance(i, i)), value = problem.to_reported(i, x(i));
    const double range = problem.upper()(i) - problem.lower()(i), half = half_of_95(spread.freedom(i));
    Estimate estimate;
    estimate.value = value;
    estimate.standard_error = p.logarithmic ? value * sd : sd;
    estimate.stated_error = estimate.standard_error * std::sqrt(spread.stated_covariance(i, i)) / sd;
    estimate.interval_low = problem.to_reported(i, std::max(x(i) - half * sd, problem.lower()(i)));
    estimate.interval_high = problem.to_reported(i, std::min(x(i) + half * sd, problem.upper()(i)));
    const bool low = x(i) - problem.lower()(i) < at_bound * range;
    estimate.at_bound = low || problem.upper()(i) - x(i) < at_bound * range;
    // a parameter that may vanish is judged against what its bounds admit
    const double size = p.lower > 0 ? std::abs(value)
                                    : std::max(std::abs(value), 0.05 * std::max(std::abs(p.lower), std::abs(p.upper)));
    const double half_width = half * estimate.standard_error;
    const double stated_half_width = half * estimate.stated_error;
    if (problem.all_grazing() && !p.seen_in_flight) {
      estimate.verdict = Verdict::grazing;
      estimate.reason = "every impact only grazes the rim: a slightly different flight would miss it";
    } else if (estimate.at_bound) {
      estimate.verdict = Verdict::bound;
      estimate.reason = fmt::format("it ended at the {} value allowed, {:.3g}{}", low ? "smallest" : "largest", value,
                                    unit_behind(p.unit));
    } else if (!(spread.condition < flat_condition)) {
      estimate.verdict = Verdict::flat;
      estimate.reason = "other values of the parameters together follow the data as well";
    } else if (!(stated_half_width <= vague * size) && spread.measured) {
      estimate.verdict = Verdict::noise;
      estimate.reason =
          fmt::format("the noise of the record leaves +-{:.0f} % of the value open", 100 * stated_half_width / size);
    } else if (!(stated_half_width <= vague * size)) {
      estimate.verdict = Verdict::flat;
      estimate.reason = fmt::format("the data leave +-{:.0f} % of the value open", 100 * stated_half_width / size);
    } else if (half_width > vague * size) {
      estimate.verdict = Verdict::form;
      const std::string says = fmt::format(
          "the data alone leave +-{:.1f} % of it open, but the law does not follow them, so the 95 % interval is "
          "+-{:.0f} %",
          100 * stated_half_width / size, 100 * half_width / size);
      if (half_width > size) // an interval that reaches zero tells nothing, whatever widened it
        estimate.reason = says;
      else
        result.notes.push_back(fmt::format("{} is determined: {}", p.name, says));
    }
    estimate.identifiable = estimate.reason.empty();
    result.parameters[p.name] = estimate;
  }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double scale = std::sqrt(spread.covariance(i, i) * spread.covariance(j, j));
      const double value = i == j ? 1.0 : std::isfinite(scale) && scale > 0 ? spread.covariance(i, j) / scale : 0.0;
      result.correlation[problem.parameter(i).name][problem.parameter(j).name] = value;
    }
}

} // namespace rimpact::calibration

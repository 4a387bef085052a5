#include "calibration/fit/uncertainty.h"
#include <cmath>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>

namespace rimpact::calibration {

namespace {

constexpr double normal_95 = 1.959964;
/// A parameter whose 95 % interval reaches this share of its value to either side is not identified.
constexpr double vague = 0.5;
/// Condition (relative changes) beyond which the valley is called flat.
constexpr double flat_condition = 1e4;
/// Share of the bounds' range within which a value counts as standing at the bound.
constexpr double at_bound = 1e-6;
/// Standard errors of a sum of squares beyond which it is no noise.
constexpr double improbable = 4;
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
double beyond_noise(const Group &group, const Eigen::VectorXd &r) {
  const Eigen::VectorXd part = r.segment(group.first, group.count);
  const double n = group.count, found = part.squaredNorm() / n;
  if (found <= group.noise * (1 + improbable * std::sqrt(2 / n + 2 / group.freedom)) + numerical) return 0;
  return (found - group.noise) * correlation_inflation(part);
}

/// The block's Jacobian less what its own unknowns can follow.
Eigen::MatrixXd effective_jacobian(const Problem &problem, const ResidualBlock &block, const Eigen::VectorXd &x,
                                   const Eigen::VectorXd &nuisance) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  RowMajor J(block.size(), problem.n_parameters()), N(block.size(), block.n_nuisance());
  if (!problem.jacobian(block, x.data(), nuisance.data(), J.data()) ||
      (N.cols() > 0 && !problem.nuisance_jacobian(block, x.data(), nuisance.data(), N.data())))
    throw std::logic_error("the fitted values cannot be evaluated");
  if (N.cols() == 0) return J;
  const Eigen::MatrixXd normal = N.transpose() * N; // the start's own residuals make it regular
  return J - N * normal.ldlt().solve(N.transpose() * J);
}

/// Derivative of Huber's loss with respect to the squared norm s.
double huber_slope(double s, double scale) {
  return scale <= 0 || s <= scale * scale ? 1.0 : scale / std::sqrt(s);
}

} // namespace

Spread spread_at(const Problem &problem, const Eigen::VectorXd &x, const Nuisance &nuisance, double robust_scale) {
  const int n = problem.n_parameters();
  Eigen::MatrixXd bread = Eigen::MatrixXd::Zero(n, n), filling = bread, stated = bread;
  Eigen::VectorXd gain = Eigen::VectorXd::Zero(n); // one error, common to all impacts
  Spread spread;
  for (std::size_t k = 0; k < problem.blocks().size(); ++k) {
    const ResidualBlock &block = *problem.blocks()[k];
    Eigen::VectorXd r(block.size());
    if (!problem.residuals(block, x.data(), nuisance[k].data(), r.data()))
      throw std::logic_error("the fitted values cannot be evaluated");
    const Eigen::MatrixXd J = effective_jacobian(problem, block, x, nuisance[k]);
    const double w = huber_slope(r.squaredNorm(), robust_scale);
    bread += w * J.transpose() * J;
    if (block.measured()) {
      const Eigen::MatrixXd noise = block.noise_filling(J);
      filling += w * w * noise, stated += w * w * noise;
      gain += w * J.transpose() * block.gain_error();
    }
    for (const auto &group : block.groups()) {
      const auto part = J.middleRows(group.first, group.count);
      const Eigen::MatrixXd square = part.transpose() * part;
      if (block.measured()) {
        const double excess = beyond_noise(group, r);
        filling += w * w * excess * square;
        spread.within_noise = spread.within_noise && excess == 0;
        continue;
      }
      filling += w * w * group_variance(group, r) * square;
      stated += w * w * group.weight * group.weight / group.count * square;
    }
    spread.measured = spread.measured || block.measured();
  }
  filling += gain * gain.transpose(), stated += gain * gain.transpose();
  Eigen::VectorXd relative(n);
  for (int i = 0; i < n; ++i) relative(i) = problem.per_relative_change(i, x(i));
  const Eigen::MatrixXd scaled = relative.asDiagonal() * bread * relative.asDiagonal();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled);
  const double least = svd.singularValues()(n - 1), most = svd.singularValues()(0);
  spread.condition = least > 0 ? std::sqrt(most / least) : std::numeric_limits<double>::infinity();
  if (!(most > 0) || least < 1e-14 * most) {
    spread.condition = std::numeric_limits<double>::infinity();
    spread.covariance = Eigen::MatrixXd::Constant(n, n, std::numeric_limits<double>::infinity());
    spread.stated_covariance = spread.covariance;
    return spread;
  }
  const Eigen::MatrixXd inverse = bread.inverse();
  spread.covariance = inverse * filling * inverse;
  spread.stated_covariance = inverse * stated * inverse;
  return spread;
}

void judge(const Problem &problem, const Eigen::VectorXd &x, const Spread &spread, FitResult &result) {
  const int n = problem.n_parameters();
  result.condition = spread.condition;
  for (int i = 0; i < n; ++i) {
    const Parameter &p = problem.parameter(i);
    const double sd = std::sqrt(spread.covariance(i, i)), value = problem.to_reported(i, x(i));
    const double range = problem.upper()(i) - problem.lower()(i);
    Estimate estimate;
    estimate.value = value;
    estimate.standard_error = p.logarithmic ? value * sd : sd;
    estimate.stated_error = estimate.standard_error * std::sqrt(spread.stated_covariance(i, i)) / sd;
    estimate.interval_low = problem.to_reported(i, std::max(x(i) - normal_95 * sd, problem.lower()(i)));
    estimate.interval_high = problem.to_reported(i, std::min(x(i) + normal_95 * sd, problem.upper()(i)));
    const bool low = x(i) - problem.lower()(i) < at_bound * range;
    estimate.at_bound = low || problem.upper()(i) - x(i) < at_bound * range;
    // a parameter that may vanish is judged against what its bounds admit
    const double size = p.lower > 0 ? std::abs(value)
                                    : std::max(std::abs(value), 0.05 * std::max(std::abs(p.lower), std::abs(p.upper)));
    const double half_width = normal_95 * estimate.standard_error;
    const double stated_half_width = normal_95 * estimate.stated_error;
    estimate.verdict = "determined";
    if (problem.all_grazing() && !p.seen_in_flight) {
      estimate.verdict = "grazing";
      estimate.reason = "every impact only grazes the rim: a slightly different flight would miss it";
    } else if (estimate.at_bound) {
      estimate.verdict = "bound";
      estimate.reason = fmt::format("it ended at its {} bound {:g} {}", low ? "lower" : "upper", value, p.unit);
    } else if (!(spread.condition < flat_condition)) {
      estimate.verdict = "flat";
      estimate.reason = fmt::format("flat valley: condition {:.3g} exceeds {:g}", spread.condition, flat_condition);
    } else if (!(stated_half_width <= vague * size) && spread.measured) {
      estimate.verdict = "noise";
      estimate.reason =
          fmt::format("the noise of the record leaves +-{:.0f} % of the value open", 100 * stated_half_width / size);
    } else if (!(stated_half_width <= vague * size)) {
      estimate.verdict = "flat";
      estimate.reason =
          fmt::format("flat: the data leave +-{:.0f} % of the value open", 100 * stated_half_width / size);
    } else if (half_width > vague * size) {
      estimate.verdict = "form";
      const std::string says = fmt::format(
          "the data alone leave +-{:.1f} % of it open, but the model's form does not follow them: what it leaves "
          "unexplained widens the 95 % interval to +-{:.0f} %",
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

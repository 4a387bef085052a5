#include "calibration/fit/uncertainty.h"
#include "calibration/fit/noise_left.h"
#include <cmath>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <limits>
#include <map>
#include <stdexcept>

namespace rimpact::calibration {

namespace {

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
  RowMajor J(block.size(), problem.n_unknowns()), N(block.size(), block.n_nuisance());
  if (!problem.residuals(block, x.data(), nuisance.data(), r.data()) ||
      !problem.jacobian(block, x.data(), nuisance.data(), r.data(), J.data()) ||
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

/// Of the normal matrix in relative changes of the parameters.
double condition_of(const Eigen::MatrixXd &relative) {
  const auto n = relative.rows();
  if (n == 0) return 1;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(relative);
  const double least = svd.singularValues()(n - 1), most = svd.singularValues()(0);
  return most > 0 && least >= 1e-14 * most ? std::sqrt(most / least) : std::numeric_limits<double>::infinity();
}

/// Of the unknowns `kept` alone; the others are held where they are.
std::vector<Linearised> columns_of(const std::vector<Linearised> &parts, const std::vector<int> &kept) {
  std::vector<Linearised> fewer = parts;
  for (Linearised &part : fewer) part.J = Eigen::MatrixXd(part.J(Eigen::all, kept));
  return fewer;
}

struct Covariances {
  Eigen::MatrixXd all, stated;
  Eigen::VectorXd freedom;
};

/// By the rows of all parts, of regular columns.
Covariances covariances(const std::vector<Linearised> &parts, const Eigen::MatrixXd &bread, bool &within_noise) {
  const auto n = bread.rows();
  Eigen::MatrixXd noise = Eigen::MatrixXd::Zero(n, n), stated = noise, found = noise;
  NoiseShares shares;
  for (const Linearised &part : parts)
    if (part.block->measured()) add_noise(shares, part);
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
      within_noise = within_noise && excess == 0;
      found += (measured ? excess : group_variance(group, part.r)) * square;
      if (!measured) stated += group.weight * group.weight / group.count * square;
    }
  }
  Covariances c{inverse * (noise + found) * inverse, inverse * (noise + stated) * inverse, {}};
  c.freedom = freedom_of(c.all, inverse, shares);
  return c;
}

Eigen::MatrixXd normal_matrix(const std::vector<Linearised> &parts) {
  Eigen::MatrixXd bread = Eigen::MatrixXd::Zero(parts.front().J.cols(), parts.front().J.cols());
  for (const Linearised &part : parts) bread += part.weight * part.J.transpose() * part.J;
  return bread;
}

} // namespace

Covariance covariance_at(const Problem &problem, const Eigen::VectorXd &x, const Nuisance &nuisance,
                         double robust_scale) {
  const int n = problem.n_unknowns();
  constexpr double unknown = std::numeric_limits<double>::infinity();
  Covariance spread;
  std::vector<Linearised> parts;
  for (std::size_t k = 0; k < problem.blocks().size(); ++k) {
    parts.push_back(linearised(problem, *problem.blocks()[k], x, nuisance[k], robust_scale));
    spread.measured = spread.measured || parts.back().block->measured();
  }
  const Eigen::MatrixXd bread = normal_matrix(parts);
  Eigen::VectorXd relative = Eigen::VectorXd::Ones(n);
  for (int i = 0; i < problem.n_parameters(); ++i) relative(i) = problem.per_relative_change(i, x(i));
  const Eigen::MatrixXd scaled = relative.asDiagonal() * bread * relative.asDiagonal();
  const auto condition = [&](const std::vector<int> &kept) { return condition_of(scaled(kept, kept)); };

  const std::vector<int> free = problem.free(x);
  spread.free.assign(n, false);
  for (const int i : free) spread.free[i] = true;
  spread.covariance = Eigen::MatrixXd::Zero(n, n), spread.freedom = Eigen::VectorXd::Constant(n, unknown);
  spread.covariance.diagonal().setConstant(unknown), spread.stated_covariance = spread.covariance;
  spread.condition = condition(free);
  if (!std::isfinite(spread.condition)) return spread;
  const auto take = [&](const std::vector<int> &kept, bool &within_noise) {
    return covariances(columns_of(parts, kept), bread(kept, kept), within_noise);
  };
  if (!free.empty()) {
    const Covariances c = take(free, spread.within_noise);
    spread.covariance(free, free) = c.all, spread.stated_covariance(free, free) = c.stated;
    spread.freedom(free) = c.freedom;
  }
  for (int i = 0; i < n; ++i) { // how far one that is held could go if the fit let it
    if (spread.free[i]) continue;
    std::vector<int> with = free;
    with.push_back(i);
    if (!std::isfinite(condition(with))) continue;
    bool unused = true;
    const Covariances c = take(with, unused);
    const auto last = c.all.rows() - 1;
    spread.covariance(i, i) = c.all(last, last), spread.stated_covariance(i, i) = c.stated(last, last);
    spread.freedom(i) = c.freedom(last);
  }
  return spread;
}

} // namespace rimpact::calibration

#include "studies/fleets/correlation.h"
#include "io/files/error.h"
#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <fmt/format.h>
#include <numeric>

namespace rimpact::fleets {
namespace {

using Matrix = Eigen::MatrixXd;

Matrix lower_factor(const Matrix &matrix) {
  const Eigen::LLT<Matrix> factor(matrix);
  if (factor.info() != Eigen::Success)
    throw InputError("the correlations of the random variables are not positive definite");
  return factor.matrixL();
}

Matrix target_matrix(const std::vector<std::vector<double>> &correlation, std::size_t dimensions) {
  if (correlation.size() != dimensions)
    throw InputError(fmt::format("{} rows of correlations for {} random variables", correlation.size(), dimensions));
  Matrix target(dimensions, dimensions);
  for (std::size_t i = 0; i < dimensions; ++i) {
    if (correlation[i].size() != dimensions)
      throw InputError(
          fmt::format("row {} of the correlations has {} numbers, not {}", i + 1, correlation[i].size(), dimensions));
    for (std::size_t j = 0; j < dimensions; ++j) target(i, j) = correlation[i][j];
  }
  for (std::size_t i = 0; i < dimensions; ++i) {
    if (target(i, i) != 1)
      throw InputError(fmt::format("correlation {} of variable {} with itself is not 1", target(i, i), i + 1));
    for (std::size_t j = 0; j < i; ++j)
      if (!(target(i, j) == target(j, i) && std::abs(target(i, j)) < 1))
        throw InputError(fmt::format("correlations {} and {} of variables {} and {} are not one number in (-1, 1)",
                                     target(i, j), target(j, i), j + 1, i + 1));
  }
  return target;
}

/// Samples in growing order of one column.
std::vector<int> order_of(const Eigen::VectorXd &column) {
  std::vector<int> order(column.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return column[a] < column[b]; });
  return order;
}

/// Normal scores of the points, each column of mean 0 and deviation 1.
Matrix normal_scores(const std::vector<std::vector<double>> &points) {
  const auto n = static_cast<Eigen::Index>(points.size()), d = static_cast<Eigen::Index>(points.front().size());
  Matrix scores(n, d);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < d; ++j) scores(i, j) = boost::math::quantile(boost::math::normal(), points[i][j]);
  for (Eigen::Index j = 0; j < d; ++j) {
    scores.col(j).array() -= scores.col(j).mean();
    scores.col(j) /= std::sqrt(scores.col(j).squaredNorm() / static_cast<double>(n));
  }
  return scores;
}

} // namespace

std::vector<std::vector<double>> correlated(std::vector<std::vector<double>> points,
                                            const std::vector<std::vector<double>> &correlation) {
  const std::size_t dimensions = points.empty() ? 0 : points.front().size();
  if (points.size() <= dimensions)
    throw InputError(fmt::format("{} samples cannot correlate {} random variables: more samples are needed",
                                 points.size(), dimensions));
  const Matrix target = target_matrix(correlation, dimensions);
  const Matrix scores = normal_scores(points);
  const Matrix present = scores.transpose() * scores / static_cast<double>(points.size());
  // Rows s become L_target L_present^-1 s: their correlation is the target's exactly; the points follow their
  // ranks.
  const Matrix wanted =
      (lower_factor(target) * lower_factor(present).triangularView<Eigen::Lower>().solve(scores.transpose()))
          .transpose();
  for (std::size_t j = 0; j < dimensions; ++j) {
    std::vector<double> sorted;
    for (const auto &point : points) sorted.push_back(point[j]);
    std::sort(sorted.begin(), sorted.end());
    const auto order = order_of(wanted.col(static_cast<Eigen::Index>(j)));
    for (std::size_t rank = 0; rank < sorted.size(); ++rank) points[order[rank]][j] = sorted[rank];
  }
  return points;
}

} // namespace rimpact::fleets

#include "buildings/support_equations.h"
#include <algorithm>
#include <cmath>
#include <Eigen/LU>

namespace rimpact::buildings {

using Eigen::Matrix3d, Eigen::Vector3d, Eigen::VectorXd;

/// By the pushes s = sum b_c N_c of a diaphragm: N_b = (rest_b - a_b . s) / own_b, whose own sum is s.
VectorXd SupportEquations::solve() const {
  std::vector<Matrix3d> matrix(n_diaphragms_, Matrix3d::Identity());
  std::vector<Vector3d> pushes(n_diaphragms_, Vector3d::Zero());
  for (const auto &row : rows_) {
    matrix[row.diaphragm] += row.push * row.response.transpose() / row.own;
    pushes[row.diaphragm] += row.push * (row.rest / row.own);
  }
  for (int d = 0; d < n_diaphragms_; ++d) pushes[d] = matrix[d].partialPivLu().solve(pushes[d]).eval();
  VectorXd N(rows_.size());
  for (std::size_t i = 0; i < rows_.size(); ++i)
    N[i] = (rows_[i].rest - rows_[i].response.dot(pushes[rows_[i].diaphragm])) / rows_[i].own;
  return N;
}

VectorXd SupportEquations::solve_without_pull(double accuracy) const {
  std::vector<Vector3d> pushes(n_diaphragms_, Vector3d::Zero());
  VectorXd N = VectorXd::Zero(rows_.size());
  for (int sweep = 0; sweep < 1000; ++sweep) { // projected Gauss-Seidel: every node's own mass rules its row
    double change = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const auto &row = rows_[i];
      Vector3d &sum = pushes[row.diaphragm];
      const double left = row.rest - row.own * N[i] - row.response.dot(sum);
      const double next = std::max(0.0, N[i] + left / (row.own + row.response.dot(row.push)));
      sum += (next - N[i]) * row.push;
      change = std::max(change, std::abs(next - N[i])), N[i] = next;
    }
    if (change <= accuracy) break;
  }
  return N;
}

} // namespace rimpact::buildings

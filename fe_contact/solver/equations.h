/// From displacement dofs to equations: each dof is fixed, free, or a multiple of one equation (ties,
/// symmetry planes, remote displacement). Masters of remote displacements come first in the numbering. Interpolated
/// nodes have none of their own: forces and tangents know them by their shapes alone.
#pragma once
#include <Eigen/Core>
#include <utility>
#include <vector>

namespace rimpact::fe {

/// A node whose displacement is a weighted sum of others'.
struct InterpolatedNode {
  unsigned node;
  std::vector<std::pair<unsigned, double>> from; ///< nodes that are not interpolated, weights
};

struct Equations {
  std::vector<int> of_dof;    ///< equation of each dof, -1: fixed at zero, or of an interpolated node
  std::vector<double> weight; ///< dof = weight * equation
  int n = 0;                  ///< number of equations
  std::vector<InterpolatedNode> interpolated = {};

  /// Displacements of all dofs from the equations' values.
  Eigen::VectorXd expand(const Eigen::VectorXd &values) const {
    Eigen::VectorXd result(of_dof.size());
    for (std::size_t i = 0; i < of_dof.size(); ++i) result[i] = of_dof[i] < 0 ? 0.0 : weight[i] * values[of_dof[i]];
    for (const auto &[node, from] : interpolated)
      for (const auto &[other, share] : from) result.segment<3>(3 * node) += share * result.segment<3>(3 * other);
    return result;
  }
  /// The equations' values from those of all dofs.
  Eigen::VectorXd gather(const Eigen::VectorXd &by_dof) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(n);
    for (std::size_t i = 0; i < of_dof.size(); ++i)
      if (of_dof[i] >= 0) result[of_dof[i]] = by_dof[i] / weight[i];
    return result;
  }
};

} // namespace rimpact::fe

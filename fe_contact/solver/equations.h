/// From displacement dofs to equations: each dof is fixed, free, or a multiple of one equation (ties,
/// symmetry planes, remote displacement). Masters of remote displacements come first in the numbering.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace rimpact::fe {

struct Equations {
  std::vector<int> of_dof;    ///< equation of each dof, -1: fixed at zero
  std::vector<double> weight; ///< dof = weight * equation
  int n = 0;                  ///< number of equations

  /// Displacements of all dofs from the equations' values.
  Eigen::VectorXd expand(const Eigen::VectorXd &values) const {
    Eigen::VectorXd result(of_dof.size());
    for (std::size_t i = 0; i < of_dof.size(); ++i) result[i] = of_dof[i] < 0 ? 0.0 : weight[i] * values[of_dof[i]];
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

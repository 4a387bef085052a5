#include "fe_contact/engine/internal_forces.h"

#include <Eigen/LU>

namespace rimpact::fe {
namespace {

using Gradients = Eigen::Map<const Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>>;

} // namespace

Eigen::Matrix3Xd internal_forces(const Solid &solid, const Discretisation &space, std::size_t cell,
                                 const Eigen::VectorXd &u, const SolidHistory &history) {
  const int n = space.nodes_per_cell;
  const SolidLaw &law = solid.law_of(cell);
  const HenckyJ2 resting = law.isochoric.at_rest();
  Eigen::Matrix3Xd moved(3, n), forces = Eigen::Matrix3Xd::Zero(3, n);
  for (int a = 0; a < n; ++a) moved.col(a) = u.segment<3>(3 * space.cell_nodes[cell * n + a]);
  const auto add = [&](const QuadratureData &rule, auto &&stress_at) {
    for (int q = 0; q < rule.n_points; ++q) {
      const std::size_t point = cell * rule.n_points + q;
      const Gradients G(&rule.gradients[point * 3 * n], 3, n);
      const Matrix3 F = Matrix3::Identity() + moved * G.transpose();
      const Matrix3 tau = to_matrix(stress_at(point, F));
      forces += rule.weights[point] * tau * F.inverse().transpose() * G;
    }
  };
  add(space.full, [&](std::size_t point, const Matrix3 &F) { return law.stress_at_rest(resting, history[point], F); });
  add(space.reduced,
      [&](std::size_t, const Matrix3 &F) -> Vector6 { return law.volumetric.at(F.determinant()).response.stress; });
  return forces;
}

} // namespace rimpact::fe

#include "fe_contact/engine/solid_fields.h"

#include <algorithm>

namespace rimpact::fe {
namespace {

/// F = 1 + grad u at one of a cell's points; G: [direction][node].
Matrix3 gradient_at(const Eigen::VectorXd &u, const unsigned *nodes, const double *G, int n) {
  Matrix3 F = Matrix3::Identity();
  for (int a = 0; a < n; ++a)
    for (int J = 0; J < 3; ++J) F.col(J) += u.segment<3>(3 * nodes[a]) * G[J * n + a];
  return F;
}

} // namespace

SolidFields fields_of(const Solid &solid, const Discretisation &space, const Eigen::VectorXd &u,
                      const SolidHistory &history) {
  SolidFields result;
  const int n = space.nodes_per_cell, n_points = space.full.n_points, n_reduced = space.reduced.n_points;
  for (std::size_t c = 0; c < space.n_cells; ++c) {
    const unsigned *nodes = &space.cell_nodes[c * n];
    const SolidLaw &law = solid.law_of(c);
    const HenckyJ2 resting = law.isochoric.at_rest();
    double strain = 0.0, damage = 0.0;
    Vector6 stress = Vector6::Zero();
    for (int q = 0; q < n_points; ++q) {
      const std::size_t point = c * n_points + q;
      const Matrix3 F = gradient_at(u, nodes, &space.full.gradients[point * 3 * n], n);
      const Vector6 tau = law.stress_at_rest(resting, history[point], F);
      strain = std::max(strain, history[point].alpha), damage = std::max(damage, history[point].damage);
      stress += tau / F.determinant() / n_points;
    }
    for (int q = 0; q < n_reduced; ++q) {
      const Matrix3 F = gradient_at(u, nodes, &space.reduced.gradients[(c * n_reduced + q) * 3 * n], n);
      stress += law.volumetric.at(F.determinant()).response.stress / F.determinant() / n_reduced;
    }
    result.plastic_strain.push_back(strain), result.damage.push_back(damage);
    const Matrix3 mean = to_matrix(stress);
    result.von_mises.push_back(std::sqrt(1.5) * (mean - mean.trace() / 3 * Matrix3::Identity()).norm());
    for (int i = 0; i < 6; ++i) result.stress[i].push_back(stress[i]);
  }
  return result;
}

double largest_plastic_strain(const SolidHistory &history) {
  double largest = 0;
  for (const auto &point : history) largest = std::max(largest, point.alpha);
  return largest;
}

} // namespace rimpact::fe

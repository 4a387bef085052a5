#include "fe_contact/engine/face_pair.h"

#include <algorithm>

namespace rimpact::fe {

using Eigen::Matrix3d;
using Eigen::Vector3d;

void FacePair::add(const PointCoupling &coupling, double area, const Vector3d &traction, const TractionTangents &D,
                   const Vector3d &nu, bool with_stiffness) {
  const int n = 3 * coupling.n;
  if (dofs.empty()) {
    dofs.assign(coupling.dofs, coupling.dofs + coupling.n);
    n_slave = coupling.n_slave, slave_signs = coupling.slave_signs;
    forces.setZero(n);
    stiffness.setZero(n, n);
  }
  for (int a = 0; a < coupling.n; ++a) forces.segment<3>(3 * a) -= area * coupling.N[a] * traction;
  if (!with_stiffness) return;
  for (int b = 0; b < coupling.n; ++b) {
    // Strain of the carrier turns the normal: d nu / d u_b = -F^-T grad N_b nu^T, by its own nodes b only.
    const Vector3d turn = D.by_nu * coupling.dxi.transpose() * Eigen::Vector2d(coupling.dN[b][0], coupling.dN[b][1]);
    const Matrix3d column = -area * (D.by_w * coupling.N[b] + turn * nu.transpose());
    // The traction changes, and the place on the carrier's face where it acts.
    const Matrix3d moved[2] = {-area * coupling.N[b] * traction * coupling.dxi.row(0),
                               -area * coupling.N[b] * traction * coupling.dxi.row(1)};
    for (int a = 0; a < coupling.n; ++a)
      stiffness.block<3, 3>(3 * a, 3 * b) +=
          coupling.N[a] * column + coupling.dN[a][0] * moved[0] + coupling.dN[a][1] * moved[1];
  }
}

void FacePair::add_to(const Equations &equations, Eigen::VectorXd &all_forces, Tangent *tangent) const {
  const int n = static_cast<int>(dofs.size());
  std::vector<int> equation(3 * n);
  std::vector<double> weight(3 * n);
  for (int a = 0; a < n; ++a)
    for (int i = 0; i < 3; ++i) {
      equation[3 * a + i] = equations.of_dof[dofs[a] + i];
      weight[3 * a + i] = equations.weight[dofs[a] + i] * (a < n_slave ? slave_signs[i] : 1.0);
    }
  std::vector<int> order; // of the columns that are equations, ascending by equation
  for (int b = 0; b < 3 * n; ++b)
    if (equation[b] >= 0) order.push_back(b);
  std::sort(order.begin(), order.end(), [&](int b, int c) { return equation[b] < equation[c]; });
  std::vector<int> sorted;
  for (const int a : order) {
    sorted.push_back(equation[a]);
    all_forces[equation[a]] += weight[a] * forces[a];
  }
  if (!tangent) return;
  Eigen::MatrixXd block(order.size(), order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = 0; j < order.size(); ++j)
      block(i, j) = weight[order[i]] * weight[order[j]] * stiffness(order[i], order[j]);
  tangent->add_block(sorted, block);
}

} // namespace rimpact::fe

#include "buildings/modes.h"
#include "io/files/error.h"
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <fmt/format.h>

namespace rimpact::buildings {

using Eigen::MatrixXd, Eigen::VectorXd;

Modes fixed_base_modes(const BuildingModel &m) {
  const auto free = m.above_base();
  if (free.empty()) return {};
  const VectorXd root = VectorXd(m.mass(free)).cwiseSqrt().cwiseInverse();
  const MatrixXd scaled = root.asDiagonal() * MatrixXd(m.stiffness(free, free)) * root.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(scaled);
  const VectorXd &squares = solver.eigenvalues();
  if (!(squares[0] > 1e-12 * squares[squares.size() - 1])) {
    int dof = 0;
    VectorXd(solver.eigenvectors().col(0)).cwiseAbs().maxCoeff(&dof);
    dof = free[dof];
    const bool slab = dof < 3 * m.n_diaphragms;
    throw InputError(fmt::format("the building is a mechanism: {} {} moves freely: nothing holds it, or it is "
                                 "far too heavy for what does",
                                 slab ? "diaphragm" : "node", slab ? dof / 3 + 1 : dof - 3 * m.n_diaphragms + 1));
  }
  return {squares.cwiseSqrt(), root.asDiagonal() * solver.eigenvectors()};
}

MatrixXd modal_damping(const BuildingModel &m, double ratio) {
  const auto free = m.above_base(), held = m.base();
  const int n = m.n_dofs();
  if (free.empty()) return MatrixXd::Zero(n, n);
  const Modes modes = fixed_base_modes(m);
  const MatrixXd momenta = VectorXd(m.mass(free)).asDiagonal() * modes.shapes;
  const MatrixXd inner = momenta * (2 * ratio * modes.omega).asDiagonal() * momenta.transpose();
  MatrixXd relative = MatrixXd::Zero(free.size(), n); // motion relative to what the base takes along
  for (std::size_t i = 0; i < free.size(); ++i) relative(i, free[i]) = 1;
  const MatrixXd along = MatrixXd(m.stiffness(free, free)).ldlt().solve(MatrixXd(m.stiffness(free, held)));
  for (std::size_t j = 0; j < held.size(); ++j) relative.col(held[j]) = along.col(j);
  return relative.transpose() * inner * relative;
}

} // namespace rimpact::buildings

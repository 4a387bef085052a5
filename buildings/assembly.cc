#include "buildings/assembly.h"
#include "buildings/beam_column.h"
#include "buildings/modes.h"
#include "io/files/error.h"
#include <algorithm>
#include <Eigen/Cholesky>
#include <fmt/format.h>

namespace rimpact::buildings {

using Eigen::MatrixXd, Eigen::VectorXd;

namespace {

MatrixXd full_stiffness(const Frame &f) {
  MatrixXd K = MatrixXd::Zero(6 * f.nodes.size(), 6 * f.nodes.size());
  for (const Element &e : f.elements) {
    const ElementMatrix k = beam_column_stiffness(f.sections[e.section], f.nodes[e.i].at, f.nodes[e.j].at, e.up);
    const int at[] = {6 * e.i, 6 * e.j};
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) K.block<6, 6>(at[a], at[b]) += k.block<6, 6>(6 * a, 6 * b);
  }
  return K;
}

/// A frame in the plane of x and z is a mechanism across it, where nothing moves: its nodes do not turn about x.
void hold_across(MatrixXd &K) {
  const double stiff = K.diagonal().maxCoeff();
  for (int i = 0; i < K.rows(); i += 6) K(i + 3, i + 3) += stiff;
}

/// Nodal dofs over the retained ones and, behind them, r_x and r_y of each node.
MatrixXd kinematics(const Frame &f, int n_retained) {
  const int n_nodes = static_cast<int>(f.nodes.size()), n_diaphragms = static_cast<int>(f.diaphragms.size());
  MatrixXd T = MatrixXd::Zero(6 * n_nodes, n_retained + 2 * n_nodes);
  for (int d = 0; d < n_diaphragms; ++d)
    for (const int i : f.diaphragms[d].nodes) {
      const Eigen::Vector2d arm = f.nodes[i].at.head<2>() - f.diaphragms[d].centre;
      T(6 * i, 3 * d) = T(6 * i + 1, 3 * d + 1) = T(6 * i + 5, 3 * d + 2) = 1;
      T(6 * i, 3 * d + 2) = -arm.y(), T(6 * i + 1, 3 * d + 2) = arm.x();
    }
  for (int i = 0; i < n_nodes; ++i) {
    T(6 * i + 2, 3 * n_diaphragms + i) = 1;
    T(6 * i + 3, n_retained + 2 * i) = T(6 * i + 4, n_retained + 2 * i + 1) = 1;
  }
  return T;
}

struct Condensed {
  MatrixXd stiffness; ///< K_rr - K_rc K_cc^-1 K_cr
  MatrixXd followers; ///< -K_cc^-1 K_cr
};
Condensed condense(const MatrixXd &K, int n) {
  const int m = static_cast<int>(K.rows()) - n;
  const MatrixXd inner = K.bottomRightCorner(m, m);
  const Eigen::LDLT<MatrixXd> solver(inner);
  const VectorXd pivots = solver.vectorD();
  if (m > 0 && !(pivots.minCoeff() > 1e-12 * inner.diagonal().maxCoeff())) {
    int worst = 0;
    pivots.minCoeff(&worst);
    VectorXd order = VectorXd::LinSpaced(m, 0, m - 1);
    order = solver.transpositionsP() * order;
    throw InputError(
        fmt::format("the building is a mechanism: node {} turns freely", static_cast<int>(order[worst]) / 2 + 1));
  }
  const MatrixXd followers = -solver.solve(K.bottomLeftCorner(m, n)),
                 result = K.topLeftCorner(n, n) + K.topRightCorner(n, m) * followers;
  return {(result + result.transpose()) / 2, followers};
}

} // namespace

std::vector<int> BuildingModel::base() const {
  std::vector<int> list{0, 1, 2};
  for (const int node : bearings) list.push_back(vertical(node));
  return list;
}

std::vector<int> BuildingModel::above_base() const {
  const auto held = base();
  std::vector<int> list;
  for (int i = 0; i < n_dofs(); ++i)
    if (std::find(held.begin(), held.end(), i) == held.end()) list.push_back(i);
  return list;
}

BuildingModel assemble(const Frame &frame) {
  frame.validate();
  BuildingModel m;
  m.n_diaphragms = static_cast<int>(frame.diaphragms.size()), m.n_nodes = static_cast<int>(frame.nodes.size());
  const int n = 3 * m.n_diaphragms + m.n_nodes;
  const MatrixXd T = kinematics(frame, n);
  MatrixXd K = full_stiffness(frame);
  if (frame.inelastic()) hold_across(K);
  const auto condensed = condense(T.transpose() * K * T, n);
  m.stiffness = condensed.stiffness;
  m.nodal = T.leftCols(n) + T.rightCols(2 * m.n_nodes) * condensed.followers;
  m.mass.resize(n);
  for (int d = 0; d < m.n_diaphragms; ++d)
    m.mass.segment<3>(3 * d) << frame.diaphragms[d].mass, frame.diaphragms[d].mass, frame.diaphragms[d].inertia;
  for (int i = 0; i < m.n_nodes; ++i) {
    m.mass[m.vertical(i)] = frame.nodes[i].vertical_mass;
    if (!frame.nodes[i].supported) continue;
    m.bearings.push_back(i);
    m.slider.push_back(T.block(6 * i, 0, 3, n));
  }
  m.damping = modal_damping(m, frame.damping_ratio);
  return m;
}

VectorXd static_displacements(const BuildingModel &m, double gravity) {
  const auto free = m.above_base();
  VectorXd weight = VectorXd::Zero(m.n_dofs()), q = weight;
  weight.tail(m.n_nodes) = -gravity * m.mass.tail(m.n_nodes);
  if (!free.empty()) {
    const VectorXd load = weight(free), sag = MatrixXd(m.stiffness(free, free)).ldlt().solve(load);
    q(free) = sag;
  }
  return q;
}

VectorXd static_reactions(const BuildingModel &m, double gravity) {
  const VectorXd held = m.stiffness * static_displacements(m, gravity);
  VectorXd reactions(m.bearings.size());
  for (std::size_t b = 0; b < m.bearings.size(); ++b) {
    const int dof = m.vertical(m.bearings[b]);
    reactions[b] = held[dof] + gravity * m.mass[dof];
  }
  return reactions;
}

} // namespace rimpact::buildings

#include "fe_contact/engine/mesh_transfer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/LU>
#include <map>
#include <utility>

namespace rimpact::fe {
namespace {

using Eigen::Vector3d;

/// Quadratic Lagrange functions at the nodes 0, 1/2, 1 of a direction, and their derivatives.
struct Quadratic {
  std::array<double, 3> N, d;
  explicit Quadratic(double x)
      : N{(1 - x) * (1 - 2 * x), 4 * x * (1 - x), x * (2 * x - 1)}, d{4 * x - 3, 4 - 8 * x, 4 * x - 1} {}
};

/// The old cells, found by their boxes.
class Cells {
public:
  explicit Cells(const Discretisation &space) : space_(space) {
    for (std::size_t c = 0; c < space.n_cells; ++c) {
      Box box{Vector3d::Constant(1e300), Vector3d::Constant(-1e300), static_cast<int>(c)};
      for (int a = 0; a < space.nodes_per_cell; ++a) {
        box.low = box.low.cwiseMin(node(c, a));
        box.high = box.high.cwiseMax(node(c, a));
      }
      const Vector3d slack =
          Vector3d::Constant(0.05 * (box.high - box.low).norm()); // Q2 faces bulge beyond their nodes
      box.low -= slack, box.high += slack;
      boxes_[space.volumes[c]].push_back(box);
    }
  }

  /// The cell of the volume that has x, or is nearest to it: no farther than a new node on a curved surface may lie off
  /// the old cells' faces. And x in the unit cell, where it may lie outside by that much.
  std::pair<int, Vector3d> find(const Vector3d &x, meshes::Volume volume) const {
    constexpr double allowed = 5e-3; // a draft mesh takes a quarter of the slider's circle with one cell [m]
    std::pair<int, Vector3d> best{-1, Vector3d::Zero()};
    double least = allowed;
    const auto boxes = boxes_.find(volume);
    if (boxes == boxes_.end()) return best;
    for (const Box &box : boxes->second) {
      if ((x.array() < box.low.array()).any() || (x.array() > box.high.array()).any()) continue;
      const Vector3d at = inverse(box.cell, x), inside = at.cwiseMax(0).cwiseMin(1);
      const double off = (at - inside).norm() > 0.5 ? allowed : (x - tangent(box.cell, inside).first).norm();
      if (!(off < least)) continue;
      best = {box.cell, at};
      least = off;
      if (at == inside) break;
    }
    return best;
  }

private:
  struct Box {
    Vector3d low, high;
    int cell;
  };
  const Vector3d &node(std::size_t cell, int a) const {
    return space_.positions[space_.cell_nodes[cell * space_.nodes_per_cell + a]];
  }

  /// A place of the cell, and the derivatives by its unit coordinates.
  std::pair<Vector3d, Eigen::Matrix3d> tangent(int cell, const Vector3d &at) const {
    const Quadratic lx(at[0]), ly(at[1]), lz(at[2]);
    Vector3d x = Vector3d::Zero();
    Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
    for (int a = 0; a < 27; ++a) {
      const auto &[i, j, l] = space_.node_places[a];
      x += lx.N[i] * ly.N[j] * lz.N[l] * node(cell, a);
      jacobian.col(0) += lx.d[i] * ly.N[j] * lz.N[l] * node(cell, a);
      jacobian.col(1) += lx.N[i] * ly.d[j] * lz.N[l] * node(cell, a);
      jacobian.col(2) += lx.N[i] * ly.N[j] * lz.d[l] * node(cell, a);
    }
    return {x, jacobian};
  }

  Vector3d inverse(int cell, const Vector3d &x) const {
    constexpr double far = 1e9;
    Vector3d at = Vector3d::Constant(0.5);
    for (int k = 0; k < 20; ++k) {
      const auto [place, jacobian] = tangent(cell, at);
      const Vector3d change = jacobian.inverse() * (x - place);
      if (!change.allFinite() || change.norm() > 10) return Vector3d::Constant(far);
      at += change;
      if (change.norm() < 1e-12) break;
    }
    return at;
  }

  const Discretisation &space_;
  std::map<meshes::Volume, std::vector<Box>> boxes_;
};

} // namespace

MeshTransfer::MeshTransfer(const Discretisation &from, const Discretisation &to)
    : from_(from), to_(to), nodes_(to.n_nodes), points_(to.n_cells * to.full.n_points) {
  const Cells cells(from);
  std::vector<char> done(to.n_nodes, 0);
  for (std::size_t c = 0; c < to.n_cells; ++c) {
    const unsigned *nodes = &to.cell_nodes[c * to.nodes_per_cell];
    const auto place = [&](const Vector3d &x) {
      const auto [cell, at] = cells.find(x, to.volumes[c]);
      return Place{cell, at};
    };
    for (int a = 0; a < to.nodes_per_cell; ++a)
      if (!std::exchange(done[nodes[a]], 1)) nodes_[nodes[a]] = place(to.positions[nodes[a]]);
    for (int q = 0; q < to.full.n_points; ++q) {
      Vector3d x = Vector3d::Zero();
      for (int a = 0; a < to.nodes_per_cell; ++a)
        x += to.full_values[q * to.nodes_per_cell + a] * to.positions[nodes[a]];
      points_[c * to.full.n_points + q] = place(x);
    }
  }
}

Eigen::VectorXd MeshTransfer::nodal(const Eigen::VectorXd &by_dof) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(to_.n_dofs());
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    if (nodes_[k].cell < 0) continue;
    const Quadratic x(nodes_[k].at[0]), y(nodes_[k].at[1]), z(nodes_[k].at[2]);
    for (int a = 0; a < 27; ++a) {
      const auto &[i, j, l] = from_.node_places[a];
      result.segment<3>(3 * k) +=
          x.N[i] * y.N[j] * z.N[l] * by_dof.segment<3>(3 * from_.cell_nodes[nodes_[k].cell * 27 + a]);
    }
  }
  return result;
}

SolidHistory MeshTransfer::history(const SolidHistory &old) const {
  SolidHistory result(points_.size());
  const auto nearest = [](double at) {
    return at < 0.5 - 0.25 * std::sqrt(0.6) ? 0 : at > 0.5 + 0.25 * std::sqrt(0.6) ? 2 : 1;
  }; // of three Gauss points
  for (std::size_t k = 0; k < points_.size(); ++k)
    if (const Place &p = points_[k]; p.cell >= 0)
      result[k] = old[p.cell * 27 + nearest(p.at[0]) + 3 * nearest(p.at[1]) + 9 * nearest(p.at[2])];
  return result;
}

} // namespace rimpact::fe

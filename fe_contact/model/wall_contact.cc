#include "fe_contact/model/wall_contact.h"

#include <cmath>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <limits>
#include <map>

namespace rimpact::fe {
namespace {

/// Centre and radius of a ball around a face.
struct Ball {
  Eigen::Vector3d centre;
  double radius;
};
Ball ball(const FaceNodes &nodes, int n) {
  Ball result{nodes.leftCols(n).rowwise().mean(), 0.0};
  for (int a = 0; a < n; ++a) result.radius = std::max(result.radius, (nodes.col(a) - result.centre).norm());
  return result;
}

/// Local nodes at the middles (or ends) of a face's edges identify it among its neighbours.
std::vector<unsigned> edge_nodes(const Face &face, int degree, int edge) {
  const int n = degree + 1;
  std::vector<unsigned> result(n);
  for (int k = 0; k < n; ++k)
    result[k] = face.nodes[edge == 0   ? k * n
                           : edge == 1 ? k * n + degree
                           : edge == 2 ? k
                                       : degree * n + k];
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace

double default_penalty(double softer_E, double cell_size) {
  return softer_E / cell_size;
}

WallContact::WallContact(const Discretisation &space, meshes::Surface slave, meshes::Surface master,
                         const ContactOptions &options)
    : space_(space), options_(options), slaves_(space.faces_of(slave)) {
  std::map<std::vector<unsigned>, int> edges;
  for (const auto *face : space.faces_of(master))
    for (int e = 0; e < 4; ++e) ++edges[edge_nodes(*face, space.degree, e)];
  for (const auto *face : space.faces_of(master)) {
    MasterFace entry{face, {}};
    for (int e = 0; e < 4; ++e) entry.open_edge[e] = edges[edge_nodes(*face, space.degree, e)] == 1;
    masters_.push_back(entry);
  }
  points_ = face_points(space, slaves_, options.points);
}

ContactState WallContact::open() const {
  const std::size_t n = points_.size();
  return {std::vector<double>(n, 0.0), std::vector<double>(n, no_gap), std::vector<double>(n, 0.0),
          std::vector<char>(n, 0)};
}

FaceNodes WallContact::nodes_at(const Face &face, const Eigen::VectorXd &u) const {
  FaceNodes nodes;
  for (std::size_t a = 0; a < face.nodes.size(); ++a)
    nodes.col(a) = space_.positions[face.nodes[a]] + u.segment<3>(3 * face.nodes[a]);
  return nodes;
}

std::vector<std::vector<const WallContact::MasterFace *>> WallContact::near_faces(const Eigen::VectorXd &u,
                                                                                  double margin) const {
  const int n = (space_.degree + 1) * (space_.degree + 1);
  std::vector<Ball> masters;
  masters.reserve(masters_.size());
  for (const auto &master : masters_) masters.push_back(ball(nodes_at(*master.face, u), n));
  std::vector<std::vector<const MasterFace *>> result(slaves_.size());
  for (std::size_t f = 0; f < slaves_.size(); ++f) {
    const Ball slave = ball(nodes_at(*slaves_[f], u), n);
    for (std::size_t m = 0; m < masters.size(); ++m)
      if ((slave.centre - masters[m].centre).norm() < slave.radius + masters[m].radius + margin)
        result[f].push_back(&masters_[m]);
  }
  return result;
}

std::vector<std::vector<int>> WallContact::cliques(const Eigen::VectorXd &u,
                                                   const Equations &equations) const {
  std::vector<std::vector<int>> result;
  const auto near = near_faces(u, options_.margin);
  for (std::size_t f = 0; f < slaves_.size(); ++f)
    for (const auto *master : near[f]) {
      std::vector<int> clique;
      for (const auto *face : {slaves_[f], master->face})
        for (const unsigned node : face->nodes)
          for (int i = 0; i < 3; ++i) clique.push_back(equations.of_dof[3 * node + i]);
      result.push_back(clique);
    }
  return result;
}

std::vector<FaceNodes> WallContact::master_nodes(const Eigen::VectorXd &u) const {
  std::vector<FaceNodes> nodes;
  nodes.reserve(masters_.size());
  for (const auto &master : masters_) nodes.push_back(nodes_at(*master.face, u));
  return nodes;
}

Eigen::Vector3d WallContact::position(const FacePoint &point, const FaceNodes &nodes) const {
  Eigen::Vector3d x = Eigen::Vector3d::Zero();
  for (int a = 0; a < point.shapes.n; ++a) x += point.shapes.N[a] * nodes.col(a);
  return x;
}

WallContact::Pair WallContact::find(const Eigen::Vector3d &x, const std::vector<const MasterFace *> &near,
                                    const std::vector<FaceNodes> &nodes, double beyond_edges) const {
  // A point just past an inner edge belongs to the neighbour; where neither claims it (a convex kink) the
  // nearer one does, up to a small overshoot. Past a free edge of the wall only `beyond_edges` of a face is
  // allowed.
  constexpr double overshoot_limit = 0.05;
  Pair best;
  double best_overshoot = overshoot_limit, best_distance = no_gap;
  for (const MasterFace *master : near) {
    const Projection p = project(x, nodes[master - masters_.data()], space_.degree, 0, 0);
    if (!p.converged) continue;
    const double beyond[4] = {-1 - p.xi, p.xi - 1, -1 - p.eta, p.eta - 1};
    double overshoot = 0;
    bool off_the_wall = false;
    for (int e = 0; e < 4; ++e) {
      if (master->open_edge[e])
        off_the_wall = off_the_wall || beyond[e] > beyond_edges;
      else
        overshoot = std::max(overshoot, beyond[e]);
    }
    if (off_the_wall || overshoot > best_overshoot) continue;
    const double distance = (x - p.point).norm();
    const bool inside = overshoot <= 1e-12;
    if (inside ? (best_overshoot > 0 || distance < best_distance) : overshoot < best_overshoot) {
      best = {master, p};
      best_overshoot = inside ? 0 : overshoot;
      best_distance = distance;
    }
  }
  return best;
}

void WallContact::settle_edges(const Eigen::VectorXd &u, ContactState &state) const {
  const auto near = near_faces(u, options_.margin);
  const auto masters = master_nodes(u);
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const auto &faces = near[points_[k].face];
    const bool on =
        !faces.empty() &&
        find(position(points_[k], nodes_at(*slaves_[points_[k].face], u)), faces, masters, 0.0).master;
    if (!on) state.multiplier[k] = 0;
    state.on_wall[k] = on;
  }
}

ContactReport WallContact::assemble(const Eigen::VectorXd &u, ContactState &state, const Equations &equations,
                                    Eigen::VectorXd *forces, SymmetricMatrix *tangent) const {
  ContactReport report;
  const auto near = near_faces(u, 0.001);
  const auto masters = master_nodes(u);
  constexpr double beyond_edges =
      0.5; // of a face's half-width, for points that cross a free edge in this step
  FaceNodes slave_nodes;
  int current = -1;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const FacePoint &point = points_[k];
    state.gap[k] = no_gap;
    state.pressure[k] = 0;
    if (!state.on_wall[k] || near[point.face].empty()) continue;
    if (point.face != current) slave_nodes = nodes_at(*slaves_[current = point.face], u);
    const Eigen::Vector3d x = position(point, slave_nodes);
    const Pair pair = find(x, near[point.face], masters, beyond_edges);
    if (!pair.master) continue;
    const Eigen::Vector3d normal = pair.master->face->orientation *
                                   pair.projection.tangent[0].cross(pair.projection.tangent[1]).normalized();
    const double gap = normal.dot(x - pair.projection.point);
    state.gap[k] = gap;
    report.smallest_gap = std::min(report.smallest_gap, gap);
    const auto law = options_.law.at(gap, state.multiplier[k]);
    state.pressure[k] = law.pressure;
    if (law.pressure <= 0) continue;
    ++report.active;
    report.penetration = std::max(report.penetration, std::abs(gap));
    report.largest_pressure = std::max(report.largest_pressure, law.pressure);
    report.force += point.area * law.pressure * normal;
    if (forces &&
        !add_point(point, *slaves_[point.face], pair, normal, gap, law, equations, *forces, tangent))
      report.pattern_holds = false;
  }
  return report;
}

bool WallContact::add_point(const FacePoint &point, const Face &slave, const Pair &pair,
                            const Eigen::Vector3d &normal, double gap, const NormalContact::Result &law,
                            const Equations &equations, Eigen::VectorXd &forces,
                            SymmetricMatrix *tangent) const {
  // Variation of the gap: dg = n . (dx_s - dx_m) = N . du; second variation as in Laursen (2002), sec. 5.3.
  constexpr int most = 6 * FaceShapes::max_nodes;
  using Row = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1>;
  const auto &p = pair.projection;
  const int n = p.shapes.n, size = 6 * n;
  Row N(size), T[2] = {Row(size), Row(size)}, NN[2] = {Row::Zero(size), Row::Zero(size)};
  const double *master_derivative[2] = {p.shapes.dxi, p.shapes.deta};
  for (int a = 0; a < n; ++a)
    for (int i = 0; i < 3; ++i) {
      const int s = 3 * a + i, m = 3 * (n + a) + i;
      N[s] = point.shapes.N[a] * normal[i];
      N[m] = -p.shapes.N[a] * normal[i];
      for (int d = 0; d < 2; ++d) {
        T[d][s] = point.shapes.N[a] * p.tangent[d][i];
        T[d][m] = -p.shapes.N[a] * p.tangent[d][i];
        NN[d][m] = master_derivative[d][a] * normal[i];
      }
    }
  int eqs[most];
  double weights[most];
  for (int a = 0; a < 2 * n; ++a)
    for (int i = 0; i < 3; ++i) {
      const unsigned dof = 3 * (a < n ? slave.nodes[a] : pair.master->face->nodes[a - n]) + i;
      eqs[3 * a + i] = equations.of_dof[dof];
      weights[3 * a + i] = equations.weight[dof];
    }
  for (int r = 0; r < size; ++r)
    if (eqs[r] >= 0) forces[eqs[r]] -= point.area * law.pressure * weights[r] * N[r];
  if (!tangent) return true;

  Eigen::Matrix2d metric, curvature;
  metric << p.tangent[0].squaredNorm(), p.tangent[0].dot(p.tangent[1]), p.tangent[0].dot(p.tangent[1]),
      p.tangent[1].squaredNorm();
  curvature << normal.dot(p.second[0]), normal.dot(p.second[1]), normal.dot(p.second[1]),
      normal.dot(p.second[2]);
  const Eigen::Matrix2d inverse = (metric - gap * curvature).inverse(), metric_inverse = metric.inverse();
  Row D[2], B[2];
  for (int d = 0; d < 2; ++d)
    D[d] = inverse(d, 0) * (T[0] + gap * NN[0]) + inverse(d, 1) * (T[1] + gap * NN[1]);
  for (int d = 0; d < 2; ++d) B[d] = NN[d] + curvature(d, 0) * D[0] + curvature(d, 1) * D[1];
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most, most> K = law.slope * N * N.transpose();
  for (int d = 0; d < 2; ++d) {
    K += law.pressure * (NN[d] * D[d].transpose() + D[d] * NN[d].transpose());
    for (int e = 0; e < 2; ++e)
      K += law.pressure *
           (curvature(d, e) * D[d] * D[e].transpose() - gap * metric_inverse(d, e) * B[d] * B[e].transpose());
  }
  for (int r = 0; r < size; ++r)
    for (int c = r; c < size; ++c) {
      if (eqs[r] < 0 || eqs[c] < 0) continue;
      const int place = tangent->find(std::min(eqs[r], eqs[c]), std::max(eqs[r], eqs[c]));
      if (place < 0) return false;
      const double twice = r != c && eqs[r] == eqs[c] ? 2.0 : 1.0;
      tangent->values()[place] += twice * point.area * weights[r] * weights[c] * K(r, c);
    }
  return true;
}

void WallContact::expect(ContactState &state, const std::vector<double> &change) {
  for (std::size_t k = 0; k < change.size(); ++k)
    if (state.multiplier[k] > 0) state.multiplier[k] = std::max(0.0, state.multiplier[k] + change[k]);
}

double WallContact::work(const ContactState &before, const ContactState &after) const {
  double sum = 0;
  for (std::size_t k = 0; k < points_.size(); ++k)
    if (before.gap[k] < no_gap && after.gap[k] < no_gap)
      sum -=
          0.5 * points_[k].area * (before.pressure[k] + after.pressure[k]) * (after.gap[k] - before.gap[k]);
  return sum;
}

void WallContact::nodal_fields(const ContactState &state, std::vector<double> &pressure,
                               std::vector<double> &gap) const {
  pressure.assign(space_.n_nodes, 0.0);
  gap.assign(space_.n_nodes, 0.0);
  std::vector<double> opposite = state.pressure, gaps = state.gap;
  for (std::size_t k = 0; k < gaps.size(); ++k)
    if (!(gaps[k] < no_gap)) opposite[k] = gaps[k] = std::numeric_limits<double>::quiet_NaN();
  average_to_nodes(points_, slaves_, opposite, pressure);
  average_to_nodes(points_, slaves_, gaps, gap);
}

} // namespace rimpact::fe

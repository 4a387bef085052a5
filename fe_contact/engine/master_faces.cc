#include "fe_contact/engine/master_faces.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <Eigen/LU>
#include <map>

namespace rimpact::fe {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::point<double, 3, bg::cs::cartesian>;
using Box = bg::model::box<Point>;

Box box_of(const Eigen::Vector3d &low, const Eigen::Vector3d &high) {
  return {Point(low[0], low[1], low[2]), Point(high[0], high[1], high[2])};
}

std::vector<unsigned> edge_nodes(const Face &face, int degree, int edge) {
  const int n = degree + 1;
  std::vector<unsigned> result;
  for (int k = 0; k < n; ++k) {
    const int at[4] = {k * n, k * n + degree, k, degree * n + k};
    result.push_back(face.nodes[at[edge]]);
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// How far a place lies past each edge [half widths], in the order of edge_nodes; below zero: inside it.
std::array<double, 4> past_edges(const Projection &p) {
  return {-1 - p.xi, p.xi - 1, -1 - p.eta, p.eta - 1};
}

} // namespace

struct MasterFaces::Tree {
  bg::index::rtree<std::pair<Box, int>, bg::index::quadratic<16>> boxes;
};

MasterFaces::MasterFaces(const Discretisation &space, meshes::Surface group)
    : space_(space), faces_(space.faces_of(group)), tree_(std::make_unique<Tree>()) {
  constexpr double reach = 0.3; // of a face's size: how far off a point is still said to be opposite
  std::map<std::vector<unsigned>, int> edges;
  for (const auto *face : faces_)
    for (int e = 0; e < 4; ++e) ++edges[edge_nodes(*face, space.degree, e)];
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const int n = static_cast<int>(faces_[f]->nodes.size());
    FaceNodes nodes = FaceNodes::Zero();
    for (int a = 0; a < n; ++a) nodes.col(a) = space.positions[faces_[f]->nodes[a]];
    const Eigen::Vector3d low = nodes.leftCols(n).rowwise().minCoeff(), high = nodes.leftCols(n).rowwise().maxCoeff();
    const Eigen::Vector3d slack = Eigen::Vector3d::Constant(reach * (high - low).norm());
    tree_->boxes.insert({box_of(low - slack, high + slack), static_cast<int>(f)});
    nodes_.push_back(nodes);
    std::array<bool, 4> open{};
    for (int e = 0; e < 4; ++e) open[e] = edges[edge_nodes(*faces_[f], space.degree, e)] == 1;
    open_edges_.push_back(open);
  }
}

MasterFaces::~MasterFaces() = default;
MasterFaces::MasterFaces(MasterFaces &&) noexcept = default;

std::vector<int> MasterFaces::near(const Eigen::Vector3d &low, const Eigen::Vector3d &high, double margin) const {
  const Eigen::Vector3d slack = Eigen::Vector3d::Constant(margin);
  std::vector<int> result;
  for (auto it = tree_->boxes.qbegin(bg::index::intersects(box_of(low - slack, high + slack)));
       it != tree_->boxes.qend(); ++it)
    result.push_back(it->second);
  std::sort(result.begin(), result.end());
  return result;
}

/// A point keeps its face a little past an inner edge: where the surface has a kink, each face may send it to the
/// other for ever.
MasterFaces::Place MasterFaces::place_on(int face, const Eigen::Vector3d &y) const {
  constexpr double hold = 0.02; // half widths
  const Projection p = project(y, nodes_[face], space_.degree, 0, 0);
  const auto past = past_edges(p);
  bool kept = p.converged;
  for (int e = 0; e < 4; ++e) kept = kept && past[e] <= (open_edges_[face][e] ? 0 : hold);
  return {p.converged ? face : -1, p, kept};
}

MasterFaces::Place MasterFaces::locate(const Eigen::Vector3d &y, int guess, double beyond) const {
  if (guess >= 0)
    if (const Place place = place_on(guess, y); place.inside) return place;
  // A point just past an inner edge belongs to the neighbour; where neither claims it (a convex kink) the one
  // it overshoots least does.
  constexpr double overshoot_limit = 0.05;
  Place best;
  double best_overshoot = overshoot_limit, best_distance = 1e300;
  for (const int f : near(y, y, 0.0)) {
    const Projection p = project(y, nodes_[f], space_.degree, 0, 0);
    if (!p.converged) continue;
    const auto past = past_edges(p);
    double overshoot = 0, off = 0;
    for (int e = 0; e < 4; ++e)
      (open_edges_[f][e] ? off : overshoot) = std::max(open_edges_[f][e] ? off : overshoot, past[e]);
    if (off > beyond || overshoot > best_overshoot) continue;
    const double distance = (y - p.point).norm();
    if (overshoot < best_overshoot - 1e-12 || distance < best_distance) {
      best = {f, p, off <= 0};
      best_overshoot = std::max(overshoot, 1e-12);
      best_distance = distance;
    }
  }
  return best;
}

Eigen::Vector3d MasterFaces::approximate_pull_back(const Eigen::Vector3d &x, const Eigen::VectorXd &u, int face) const {
  const auto &nodes = faces_[std::max(face, 0)]->nodes;
  return x - u.segment<3>(3 * nodes[nodes.size() / 2]);
}

Eigen::Vector3d MasterFaces::rigid_pull_back(const Eigen::Vector3d &x, const Eigen::VectorXd &u, int face) const {
  const Face &at = *faces_[std::max(face, 0)];
  const FaceShapes shapes = face_shapes(space_.degree, 0, 0);
  const auto frame_of = [&](bool moved) { // its middle, two tangents and the normal
    Eigen::Matrix<double, 3, 4> frame = Eigen::Matrix<double, 3, 4>::Zero();
    for (int a = 0; a < shapes.n; ++a) {
      const unsigned node = at.nodes[a];
      const Eigen::Vector3d place =
          moved ? Eigen::Vector3d(space_.positions[node] + u.segment<3>(3 * node)) : space_.positions[node];
      frame.col(0) += shapes.N[a] * place;
      frame.col(1) += shapes.dxi[a] * place;
      frame.col(2) += shapes.deta[a] * place;
    }
    const Eigen::Vector3d along = frame.col(1), across = frame.col(2);
    frame.col(3) = along.cross(across).normalized();
    return frame;
  };
  const Eigen::Matrix<double, 3, 4> before = frame_of(false), now = frame_of(true);
  const Eigen::Matrix3d turned = now.rightCols<3>();
  return before.col(0) + before.rightCols<3>() * turned.inverse() * (x - now.col(0));
}

double MasterFaces::displacement_spread(const Eigen::VectorXd &u, int face) const {
  double largest = 0;
  for (const unsigned node : faces_[std::max(face, 0)]->nodes)
    largest = std::max(largest, approximate_pull_back(u.segment<3>(3 * node), u, face).norm());
  return largest;
}

Opposite MasterFaces::find(const Eigen::Vector3d &x, const Eigen::VectorXd &u, int guess, double beyond) const {
  if (faces_.empty()) return {};
  // First the guess alone, however far off its edges the way there leads: which of two faces beside a kink is found
  // must not depend on where the search began, or Newton sees a force that jumps to and fro.
  Eigen::Vector3d start = approximate_pull_back(x, u, guess);
  if (guess >= 0) {
    const Opposite kept =
        solve_opposite(x, u, {guess, start}, [&](const Eigen::Vector3d &y, int) { return place_on(guess, y); });
    if (kept.inside) return kept;
    if (kept.face >= 0) start = kept.y; // past an edge: the neighbour is there, and not where the middle's motion leads
  }
  return solve_opposite(x, u, {guess, start},
                        [&](const Eigen::Vector3d &y, int last) { return locate(y, last, beyond); });
}

/// Newton's method for the place where y + u_m(y) = x, at the places that `search` finds, from the last one's face.
template <typename Search>
Opposite MasterFaces::solve_opposite(const Eigen::Vector3d &x, const Eigen::VectorXd &u, const Start &from,
                                     const Search &search) const {
  Opposite result;
  result.y = from.y;
  int guess = from.face;
  const double tolerance = 1e-15 * (1 + x.norm());
  constexpr double settled = 1e-9; // [m]; two faces with a kink between them may send a point to and fro by less
  double error = 0;
  for (int iteration = 0; iteration < 12; ++iteration) {
    const Place place = search(result.y, guess);
    if (place.face < 0) return {};
    guess = result.face = place.face;
    result.inside = place.inside;
    const Projection &p = place.projection;
    result.shapes = p.shapes;
    Eigen::Vector3d carried = Eigen::Vector3d::Zero();
    Eigen::Matrix<double, 3, 2> gradient = Eigen::Matrix<double, 3, 2>::Zero();
    for (auto &second : result.second) second.setZero();
    for (int a = 0; a < p.shapes.n; ++a) {
      const Eigen::Vector3d ua = u.segment<3>(3 * faces_[place.face]->nodes[a]);
      carried += p.shapes.N[a] * ua;
      gradient.col(0) += p.shapes.dxi[a] * ua;
      gradient.col(1) += p.shapes.deta[a] * ua;
      result.second[0] += p.shapes.dxixi[a] * ua;
      result.second[1] += p.shapes.dxieta[a] * ua;
      result.second[2] += p.shapes.detaeta[a] * ua;
    }
    const Eigen::Vector3d off = result.y - p.point;
    Eigen::Matrix2d metric;
    metric << p.tangent[0].squaredNorm() - p.second[0].dot(off), p.tangent[0].dot(p.tangent[1]) - p.second[1].dot(off),
        p.tangent[0].dot(p.tangent[1]) - p.second[1].dot(off), p.tangent[1].squaredNorm() - p.second[2].dot(off);
    Eigen::Matrix<double, 2, 3> tangents;
    tangents << p.tangent[0].transpose(), p.tangent[1].transpose();
    const Eigen::Matrix<double, 2, 3> dxi_dy = metric.inverse() * tangents;
    result.inverse = (Eigen::Matrix3d::Identity() + gradient * dxi_dy).inverse();
    result.dxi = dxi_dy * result.inverse;
    const Eigen::Vector3d residual = result.y + carried - x;
    error = residual.norm();
    if (error <= tolerance) return result;
    result.y -= result.inverse * residual;
    if (iteration > 3 && error < 1e-12 * (1 + x.norm())) return result;
  }
  return error < settled ? result : Opposite();
}

} // namespace rimpact::fe

#include "fe_contact/engine/contact_search.h"

#include "fe_contact/solver/ranks.h"
#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace rimpact::fe {

using Eigen::Vector3d;

ContactSearch::ContactSearch(const Discretisation &space, meshes::Surface slave, MasterSurface master,
                             const SurfaceContactOptions &options)
    : space_(space), master_(std::move(master)), carrier_dof_(options.carrier_dof), margin_(options.margin),
      points_a_face_(options.points * options.points), faces_(space.faces_of(slave)),
      points_(face_points(space, faces_, options.points)) {
  if (options.carrier_faces) carrier_.emplace(space, *options.carrier_faces);
  if (!options.image) return;
  const OwnImage &image = *options.image;
  carrier_dof_ = image.dof;
  carrier_weight_ = 2;
  signs_ = image.signs;
  image_of_origin_ = image.centre - signs_.cwiseProduct(image.centre);
  pass_share_ = 0.5;
  for (FacePoint &point : points_) point.area *= pass_share_;
}

Vector3d ContactSearch::position(const FacePoint &point, const Eigen::VectorXd &u) const {
  Vector3d x = Vector3d::Zero();
  for (int a = 0; a < point.shapes.n; ++a) {
    const unsigned node = faces_[point.face]->nodes[a];
    x += point.shapes.N[a] * (space_.positions[node] + u.segment<3>(3 * node));
  }
  return image_of_origin_ + seen(x, u);
}

Vector3d ContactSearch::seen(const Vector3d &slave, const Eigen::VectorXd &by_dof) const {
  const Vector3d result = signs_.cwiseProduct(slave);
  return carrier_dof_ < 0 ? result : result + carrier_weight_ * by_dof.segment<3>(carrier_dof_);
}

std::optional<PointCoupling> ContactSearch::couple(std::size_t k, const Eigen::VectorXd &u, int guess,
                                                   double beyond) const {
  const FacePoint &point = points_[k];
  PointCoupling result;
  for (int a = 0; a < point.shapes.n; ++a) result.add(3 * faces_[point.face]->nodes[a], point.shapes.N[a]);
  result.n_slave = result.n;
  result.slave_signs = signs_;
  result.y = position(point, u);
  if (carrier_dof_ >= 0) result.add(carrier_dof_, carrier_weight_);
  if (carrier_) {
    const Opposite opposite = carrier_->find(result.y, u, guess, beyond);
    if (opposite.face < 0) return {};
    result.y = opposite.y;
    result.inverse = opposite.inverse;
    result.dxi = opposite.dxi;
    std::copy(std::begin(opposite.second), std::end(opposite.second), std::begin(result.second));
    result.carrier_face = opposite.face;
    result.inside = opposite.inside;
    for (int a = 0; a < opposite.shapes.n; ++a)
      result.add(3 * carrier_->face(opposite.face).nodes[a], -opposite.shapes.N[a], -opposite.shapes.dxi[a],
                 -opposite.shapes.deta[a]);
  }
  if (master_.covers) result.inside = result.inside && master_.covers(result.y);
  return result;
}

Vector3d ContactSearch::relative_position(std::size_t k, const Eigen::VectorXd &u, int opposite) const {
  if (const auto coupling = couple(k, u, opposite, reach_past_edges)) return coupling->y;
  return position_by_motion(k, u, opposite);
}

Vector3d ContactSearch::position_by_motion(std::size_t k, const Eigen::VectorXd &u, int opposite) const {
  return carrier_->rigid_pull_back(position(points_[k], u), u, opposite);
}

bool ContactSearch::is_candidate(std::size_t k, const Eigen::VectorXd &u, int opposite) const {
  const double rough = 2 * carrier_->displacement_spread(u, opposite); // twice, as the point lies past that face
  return master_.distance(carrier_->approximate_pull_back(position(points_[k], u), u, opposite)).gap < rough;
}

Couplings ContactSearch::couplings(const Equations &equations, const Eigen::VectorXd &u,
                                   const std::vector<int> &opposite) {
  Couplings result;
  pairs_.assign(faces_.size(), {});
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    std::vector<int> own;
    const auto add = [&](std::vector<int> &clique, int dof) {
      for (int i = 0; i < 3; ++i) clique.push_back(equations.of_dof[dof + i]);
    };
    for (const unsigned node : faces_[f]->nodes) add(own, 3 * node);
    if (carrier_dof_ >= 0) add(own, carrier_dof_);
    if (!carrier_) {
      result.push_back(own);
      continue;
    }
    Vector3d low = Vector3d::Constant(1e300), high = -low;
    std::set<int> pairs;
    for (std::size_t k = f * points_a_face_; k < (f + 1) * points_a_face_; ++k) {
      // Where the carrier is dented by more than the margin, only the search itself knows what lies opposite.
      const auto found = couple(k, u, opposite[k], reach_past_edges);
      const Vector3d y = found ? found->y : carrier_->approximate_pull_back(position(points_[k], u), u);
      if (found) pairs.insert(found->carrier_face);
      low = low.cwiseMin(y);
      high = high.cwiseMax(y);
    }
    for (const int face : carrier_->near(low, high, margin_)) pairs.insert(face);
    pairs_[f].assign(pairs.begin(), pairs.end());
    for (const int master : pairs_[f]) {
      result.push_back(own);
      for (const unsigned node : carrier_->face(master).nodes) add(result.back(), 3 * node);
    }
  }
  return result;
}

bool ContactSearch::in_pattern(std::size_t face, int carrier_face) const {
  return std::binary_search(pairs_[face].begin(), pairs_[face].end(), carrier_face);
}

double ContactSearch::stiffness_per_area(const Equations &equations, const Eigen::VectorXd &diagonal) const {
  // The nodes of an edge know whether the faces beside it have middles. A face's own middle does not; the nine nodes of
  // a block's face have some four and a half times as much as it.
  constexpr double nine_over_middle = 4.5;
  double stiffness = 0, area = 0;
  const auto of_node = [&](unsigned node) {
    double sum = 0;
    for (int i = 0; i < 3; ++i)
      if (const int equation = equations.of_dof[3 * node + i]; equation >= 0) sum += diagonal[equation] / 3;
    return sum;
  };
  for (const auto *face : faces_)
    if (face->nodes.size() == 9)
      stiffness += nine_over_middle * of_node(face->nodes[4]);
    else
      for (const unsigned node : face->nodes) stiffness += of_node(node);
  for (const auto &point : points_) area += point.area;
  return ranks().all_reduce_sum(stiffness) * pass_share_ / area;
}

double ContactSearch::time_to_touch(const Eigen::VectorXd &u, const Eigen::VectorXd &v,
                                    const std::vector<int> &opposite) const {
  double time = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const FacePoint &point = points_[k];
    Vector3d y = position(point, u), velocity = Vector3d::Zero();
    for (int a = 0; a < point.shapes.n; ++a)
      velocity += point.shapes.N[a] * v.segment<3>(3 * faces_[point.face]->nodes[a]);
    velocity = seen(velocity, v);
    if (carrier_) {
      y = carrier_->approximate_pull_back(y, u, opposite[k]);
      velocity = velocity + carrier_->approximate_pull_back(Vector3d::Zero(), v, opposite[k]);
    }
    if (master_.covers && !master_.covers(y)) continue;
    const Distance distance = master_.distance(y);
    const double closing = -velocity.dot(distance.normal);
    if (closing > 0) time = std::min(time, std::max(0.0, distance.gap) / closing);
  }
  return time;
}

} // namespace rimpact::fe

#include "fe_contact/rungs/rim_foot.h"

#include "fe_contact/engine/internal_forces.h"
#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <set>

namespace rimpact::fe {
namespace {

using Eigen::Vector3d;
using meshes::Volume;

constexpr double same_angle = 1e-6; ///< [rad]

std::set<unsigned> nodes_of(const Discretisation &space, Volume volume) {
  std::set<unsigned> result;
  const int n = space.nodes_per_cell;
  for (std::size_t c = 0; c < space.n_cells; ++c)
    if (space.volumes[c] == volume) result.insert(&space.cell_nodes[c * n], &space.cell_nodes[c * n] + n);
  return result;
}

double angle_of(const Vector3d &x) {
  return std::atan2(x.y(), x.x());
}

/// Lagrange's shapes of degree 1 or 2 on [-1, 1]: value and slope of the one at `place`, of 0 ... degree.
std::pair<double, double> shape(int degree, int place, double xi) {
  if (degree == 1) return place == 0 ? std::pair{(1 - xi) / 2, -0.5} : std::pair{(1 + xi) / 2, 0.5};
  if (place == 0) return {xi * (xi - 1) / 2, xi - 0.5};
  if (place == 1) return {1 - xi * xi, -2 * xi};
  return {xi * (xi + 1) / 2, xi + 0.5};
}

constexpr double gauss_points[3] = {-0.7745966692414834, 0, 0.7745966692414834};
constexpr double gauss_weights[3] = {5.0 / 9, 8.0 / 9, 5.0 / 9};

} // namespace

RimFoot::RimFoot(const Discretisation &space, const Solid &solid, const scene::Bearing &bearing, bool half)
    : space_(space), solid_(solid), bearing_(bearing), half_(half) {
  find_section();
  for (const unsigned node : nodes_) angles_.push_back(angle_of(space.positions[node]));
  std::sort(angles_.begin(), angles_.end());
  angles_.erase(
      std::unique(angles_.begin(), angles_.end(), [](double a, double b) { return std::abs(a - b) < same_angle; }),
      angles_.end());
}

void RimFoot::find_section() {
  const std::set<unsigned> plate = nodes_of(space_, Volume::plate), rim = nodes_of(space_, Volume::rim);
  std::set_intersection(plate.begin(), plate.end(), rim.begin(), rim.end(), std::back_inserter(nodes_));
  areas_.assign(nodes_.size(), 0);
  on_cut_.assign(nodes_.size(), false);
  for (const auto group : {meshes::Surface::symmetry, meshes::Surface::sector_end})
    for (const unsigned node : space_.nodes_of(group))
      if (const auto found = std::lower_bound(nodes_.begin(), nodes_.end(), node);
          found != nodes_.end() && *found == node)
        on_cut_[found - nodes_.begin()] = true;
  const int n = space_.nodes_per_cell, degree = space_.degree;
  for (std::size_t c = 0; c < space_.n_cells; ++c) {
    if (space_.volumes[c] != Volume::rim) continue;
    const unsigned *cell = &space_.cell_nodes[c * n];
    const auto in_section = [&](int a) { return std::binary_search(nodes_.begin(), nodes_.end(), cell[a]); };
    bool any = false;
    for (int a = 0; a < n; ++a) any = any || in_section(a);
    if (!any) continue;
    cells_.push_back(c);
    for (int axis = 0; axis < 3; ++axis)
      for (const int end : {0, degree}) {
        bool whole = true;
        for (int a = 0; a < n; ++a) whole = whole && (space_.node_places[a][axis] != end || in_section(a));
        if (whole) add_area(c, axis, end);
      }
  }
}

/// Integrals of the shapes over a cell's face in the section.
void RimFoot::add_area(std::size_t cell, int axis, int end) {
  const int n = space_.nodes_per_cell, degree = space_.degree, first = (axis + 1) % 3, second = (axis + 2) % 3;
  for (int p = 0; p < 9; ++p) {
    const double xi = gauss_points[p % 3], eta = gauss_points[p / 3];
    Vector3d by_xi = Vector3d::Zero(), by_eta = Vector3d::Zero();
    std::vector<std::pair<unsigned, double>> values;
    for (int a = 0; a < n; ++a) {
      const auto &place = space_.node_places[a];
      if (place[axis] != end) continue;
      const unsigned node = space_.cell_nodes[cell * n + a];
      const auto [v, dv] = shape(degree, place[first], xi);
      const auto [w, dw] = shape(degree, place[second], eta);
      by_xi += dv * w * space_.positions[node], by_eta += v * dw * space_.positions[node];
      values.emplace_back(node, v * w);
    }
    const double area = gauss_weights[p % 3] * gauss_weights[p / 3] * by_xi.cross(by_eta).norm();
    for (const auto &[node, value] : values)
      areas_[std::lower_bound(nodes_.begin(), nodes_.end(), node) - nodes_.begin()] += area * value;
  }
}

Eigen::Matrix3Xd RimFoot::nodal_forces(const Eigen::VectorXd &u, const SolidHistory &history) const {
  Eigen::Matrix3Xd result = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(nodes_.size()));
  const int n = space_.nodes_per_cell;
  for (const std::size_t c : cells_) {
    const Eigen::Matrix3Xd forces = internal_forces(solid_, space_, c, u, history);
    for (int a = 0; a < n; ++a)
      if (const auto found = std::lower_bound(nodes_.begin(), nodes_.end(), space_.cell_nodes[c * n + a]);
          found != nodes_.end() && *found == space_.cell_nodes[c * n + a])
        result.col(found - nodes_.begin()) -= forces.col(a);
  }
  return result;
}

std::vector<RimFoot::Share> RimFoot::shares(const Eigen::VectorXd &u, const SolidHistory &history) const {
  const Eigen::Matrix3Xd forces = nodal_forces(u, history);
  std::vector<Share> result;
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const Vector3d &x = space_.positions[nodes_[k]], f = forces.col(static_cast<Eigen::Index>(k));
    const Vector3d now = x + u.segment<3>(3 * nodes_[k]);
    const double angle = angle_of(x), c = std::cos(angle), s = std::sin(angle);
    const double along = on_cut_[k] ? 0 : -s * f.x() + c * f.y();
    const Share share{angle, areas_[k], c * f.x() + s * f.y(), along, f.z(), c * now.x() + s * now.y(), now.z()};
    result.push_back(share);
    if (!half_) continue;
    result.push_back(share); // its image
    result.back().angle = -angle, result.back().along = -along;
  }
  return result;
}

FootLine RimFoot::line_at(double angle, const std::vector<Share> &shares) const {
  const double wall = bearing_.wall_radius(), thickness = bearing_.rim.thickness;
  const double reach = foot_reach(bearing_) / (wall + thickness / 2);
  struct Weighted {
    const Share *share;
    double weight;
  };
  std::vector<Weighted> near;
  double area = 0, r = 0, z = 0;
  for (const Share &share : shares) {
    const double off = std::remainder(share.angle - angle, 2 * M_PI) / reach, rest = 1 - off * off;
    if (!(rest > 0)) continue;
    const double weight = rest * rest;
    near.push_back({&share, weight});
    area += weight * share.area, r += weight * share.area * share.r, z += weight * share.area * share.z;
  }
  FootLine line;
  if (!(area > 0)) return line;
  r /= area, z /= area;
  for (const auto &[share, weight] : near) {
    const double per_length = weight * thickness / area;
    line.normal += per_length * share->vertical, line.shear += per_length * share->radial;
    line.along += per_length * share->along;
    line.moment += per_length * ((share->z - z) * share->radial - (share->r - r) * share->vertical);
  }
  return line;
}

FootForces RimFoot::of(const Eigen::VectorXd &u, const SolidHistory &history) const {
  FootForces result;
  if (!exists()) return result;
  const std::vector<Share> all = shares(u, history);
  double area = 0, r = 0, z = 0;
  for (const Share &share : all) area += share.area, r += share.area * share.r, z += share.area * share.z;
  r /= area, z /= area;
  Eigen::Vector2d horizontal = Eigen::Vector2d::Zero();
  for (const Share &share : all) {
    const double c = std::cos(share.angle), s = std::sin(share.angle);
    result.normal += share.vertical;
    horizontal += Eigen::Vector2d(c * share.radial - s * share.along, s * share.radial + c * share.along);
    result.moment += (share.z - z) * share.radial - (share.r - r) * share.vertical;
  }
  result.shear = horizontal.norm();
  double worst = -1;
  for (const double angle : angles_) {
    const FootLine line = line_at(angle, all);
    const double weld = weld_force(line, bearing_.rim.thickness);
    const auto use = foot_use(bearing_, line);
    if (use.value_or(weld) <= worst) continue;
    worst = use.value_or(weld);
    result.worst = line, result.weld = weld, result.use = use;
  }
  return result;
}

} // namespace rimpact::fe

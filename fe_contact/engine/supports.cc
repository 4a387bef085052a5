#include "fe_contact/engine/supports.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <map>

namespace rimpact::fe {

void Supports::fix(meshes::Surface group, int component) {
  for (const unsigned node : space_.nodes_of(group)) of_dof_[3 * node + component] = -1;
}

void Supports::fix(int component, const std::function<bool(const Eigen::Vector3d &)> &where) {
  for (std::size_t node = 0; node < space_.n_nodes; ++node)
    if (where(space_.positions[node])) of_dof_[3 * node + component] = -1;
}

void Supports::fix(meshes::Volume volume) {
  const int n = space_.nodes_per_cell;
  for (std::size_t c = 0; c < space_.n_cells; ++c)
    for (int k = 0; k < 3 * n && space_.volumes[c] == volume; ++k)
      of_dof_[3 * space_.cell_nodes[c * n + k / 3] + k % 3] = -1;
}

int Supports::tie(meshes::Surface group, int component) {
  for (const unsigned node : space_.nodes_of(group)) of_dof_[3 * node + component] = n_;
  return n_++;
}

int Supports::tie(int component, const std::function<bool(const Eigen::Vector3d &)> &where) {
  for (std::size_t node = 0; node < space_.n_nodes; ++node)
    if (where(space_.positions[node])) of_dof_[3 * node + component] = n_;
  return n_++;
}

void Supports::slide_on(meshes::Surface cuts) {
  struct Kinds {
    bool about_axis = false, radial = false;
  };
  std::map<unsigned, Kinds> kinds_of;
  for (const Face *face : space_.faces_of(cuts)) {
    const std::size_t m = std::size_t(space_.degree) + 1;
    const auto at = [&](std::size_t k) { return space_.positions[face->nodes[k]]; };
    const Eigen::Vector3d normal = (at(m * m - 1) - at(0)).cross(at(m * (m - 1)) - at(m - 1)).normalized();
    const bool about_axis = std::abs(normal.head<2>().dot(at(0).head<2>().normalized())) > std::sqrt(0.5);
    for (const unsigned node : face->nodes) (about_axis ? kinds_of[node].about_axis : kinds_of[node].radial) = true;
  }
  for (const auto &[node, kinds] : kinds_of) {
    if (space_.is_interpolated[node]) continue;
    int *of = &of_dof_[3 * node];
    if (of[0] == -1) continue;
    if (kinds.about_axis && (kinds.radial || of[1] == -1)) {
      of[0] = of[1] = -1;
      continue;
    }
    const Eigen::Vector2d out = space_.positions[node].head<2>().normalized();
    const Eigen::Vector2d allowed = kinds.about_axis ? Eigen::Vector2d(-out.y(), out.x()) : out;
    of[0] = of[1] = n_++;
    weight_[3 * node] = allowed.x();
    weight_[3 * node + 1] = allowed.y();
  }
}

int Supports::add_body() {
  const int first = static_cast<int>(of_dof_.size());
  of_dof_.insert(of_dof_.end(), 3, unnumbered);
  weight_.insert(weight_.end(), 3, 1.0);
  return first;
}

Equations Supports::number() {
  for (const InterpolatedNode &middle : space_.interpolated) std::fill_n(&of_dof_[std::size_t(3) * middle.node], 3, -1);
  for (int &equation : of_dof_)
    if (equation == unnumbered) equation = n_++;
  Equations result;
  result.of_dof = of_dof_;
  result.weight = weight_;
  result.n = n_;
  result.interpolated = space_.interpolated;
  return result;
}

} // namespace rimpact::fe

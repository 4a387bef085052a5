#include "fe_contact/rungs/serendipity_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rimpact::fe {
namespace {

using meshes::Surface, meshes::Volume;

class SurfaceNodes {
public:
  SurfaceNodes(const Discretisation &space, Surface group) {
    for (const unsigned node : space.nodes_of(group)) nodes_.push_back(space.positions[node]);
  }
  /// To the nearest of them [m].
  double distance(const Eigen::Vector3d &x) const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto &node : nodes_) least = std::min(least, (node - x).squaredNorm());
    return std::sqrt(least);
  }

private:
  std::vector<Eigen::Vector3d> nodes_;
};

Eigen::Vector3d middle_of(const Discretisation &space, std::size_t cell) {
  const auto middle = std::ranges::find(space.node_places, std::array{1, 1, 1}) - space.node_places.begin();
  return space.positions[space.cell_nodes[cell * space.nodes_per_cell + middle]];
}

/// From the lowest node of a surface down to the lowest of all; nil without such a surface [m].
double thickness_under(const Discretisation &space, Surface group) {
  double lowest = std::numeric_limits<double>::infinity(), foot = lowest;
  for (const auto &x : space.positions) lowest = std::min(lowest, x.z());
  for (const unsigned node : space.nodes_of(group)) foot = std::min(foot, space.positions[node].z());
  return std::isfinite(foot) ? foot - lowest : 0;
}

} // namespace

std::vector<char> serendipity_cells(const Discretisation &space, const scene::Bearing &bearing) {
  const double reach = std::max(bearing.rim.height, thickness_under(space, Surface::rim_wall) / 2);
  const SurfaceNodes side(space, Surface::slider_side), wall(space, Surface::rim_wall);
  const auto little_happens = [&](std::size_t cell) {
    switch (space.volumes[cell]) {
    case Volume::pad:
    case Volume::foot:
      return true;
    case Volume::upper_slider:
      return side.distance(middle_of(space, cell)) > bearing.slider.diameter / 6;
    case Volume::plate:
      return wall.distance(middle_of(space, cell)) > reach;
    case Volume::rim:
      break;
    }
    return false;
  };
  std::vector<char> result;
  for (std::size_t cell = 0; cell < space.n_cells; ++cell) result.push_back(little_happens(cell));
  return result;
}

} // namespace rimpact::fe

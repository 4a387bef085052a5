#include "meshes/curved_edges.h"

#include "meshes/cell_nodes.h"
#include "meshes/hex_order.h"
#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

namespace rimpact::meshes {
namespace {

constexpr double same = 1e-5; // [m]

using Point = Eigen::Map<Eigen::Vector3d>;
Point at(HexMesh &mesh, unsigned node) {
  return Point(mesh.nodes[node].data());
}

/// Corners of outer walls that do not keep one radius: where walls are flat, or meet.
std::set<unsigned> angular_nodes(HexMesh &mesh, const std::vector<double> &axes) {
  std::map<std::array<unsigned, 4>, Surface> groups;
  for (const auto &face : mesh.faces) groups[sorted(face.corners)] = face.group;
  const BoundaryOfCells boundary(mesh);
  std::set<unsigned> result;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const auto &face : hex_faces) {
      std::array<unsigned, 4> corners;
      for (int k = 0; k < 4; ++k) corners[k] = mesh.cells[c][face[k]];
      if (groups.count(sorted(corners)) || !boundary.has(corners))
        continue; // named faces: on the bearing's surfaces, or cuts
      const auto normal =
          (at(mesh, corners[2]) - at(mesh, corners[0])).cross(at(mesh, corners[3]) - at(mesh, corners[1])).normalized();
      double low = INFINITY, high = 0;
      for (const unsigned node : corners) {
        const double r = std::hypot(mesh.nodes[node][0] - axes[c], mesh.nodes[node][1]);
        low = std::min(low, r), high = std::max(high, r);
      }
      if (std::abs(normal.z()) < 0.7 && high - low > same) result.insert(corners.begin(), corners.end());
    }
  return result;
}

} // namespace

void curve_edges(HexMesh &mesh, double travel) {
  std::vector<double> axes;
  for (const Volume body : mesh.volumes) axes.push_back(body == Volume::plate || body == Volume::rim ? 0.0 : travel);
  const auto angular = angular_nodes(mesh, axes);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const auto &cell = mesh.cells[c];
    const Eigen::Vector2d axis(axes[c], 0);
    bool changed = false;
    for (int e = 0; e < 12; ++e) {
      const unsigned a = cell[hex27_edges[e][0]], b = cell[hex27_edges[e][1]];
      if (angular.count(a) && angular.count(b)) continue;
      const double radius = (at(mesh, a).head<2>() - axis).norm(), other = (at(mesh, b).head<2>() - axis).norm();
      const Point middle = at(mesh, cell[8 + e]);
      const Eigen::Vector2d out = middle.head<2>() - axis;
      // Within 83 degrees: a longer edge crosses the body, past its axis.
      if (std::abs(radius - other) > same || std::abs(at(mesh, a).z() - at(mesh, b).z()) > same ||
          out.norm() < 0.75 * radius)
        continue;
      const Eigen::Vector2d on_circle = axis + 0.5 * (radius + other) * out.normalized(); // from either cell the same
      changed = changed || (on_circle - middle.head<2>()).norm() > 1e-9;
      at(mesh, cell[8 + e]).head<2>() = on_circle;
    }
    if (changed) complete_from_edges(mesh, cell);
  }
}

} // namespace rimpact::meshes

#include "meshes/rim_mesh.h"

#include "meshes/mirror.h"
#include "meshes/own_mesh.h"
#include "meshes/plate_section.h"
#include "meshes/slider_section.h"
#include <algorithm>
#include <cmath>

namespace rimpact::meshes {
namespace {
constexpr double mm = 1e-3;
} // namespace

void add_rim(HexMesh &mesh, const scene::Bearing &bearing, const RimMeshOptions &options) {
  const double h = size_factor(options.level);
  const double wall = bearing.surface.planar_radius + bearing.rim.ledge;
  const double fine = 10 * mm * h / wall, zone = 20 * mm / wall;
  std::vector<double> angles = graded_lines({{0, fine}, {zone, fine}, {options.sector_half_angle, 0.45 * h}});
  if (options.opposite) {
    std::reverse(angles.begin(), angles.end());
    for (double &angle : angles) angle = M_PI - angle;
  }
  Body(mesh).revolve(plate_and_rim(bearing, {options.plate_inner_radius, 60 * mm * h, plate_layers(bearing, h)}, h), angles, 0.0,
                     options.opposite ? Surface::sector_end : Surface::symmetry,
                     options.opposite ? Surface::symmetry : Surface::sector_end);
}

void flatten(HexMesh &mesh) {
  for (auto &node : mesh.nodes)
    if (std::abs(node[1]) < 1e-12) node[1] = 0;
}

HexMesh rim_mesh(const scene::Bearing &bearing, const RimMeshOptions &options) {
  if (options.own.any())
    return own_mesh(options.own, bearing, {{Volume::plate, Volume::rim, Volume::upper_slider}, rim_groups, bearing.lateral_capacity(), options.half});
  HexMesh mesh;
  add_rim(mesh, bearing, options);
  add_slider(mesh, bearing, size_factor(options.level), bearing.lateral_capacity());
  flatten(mesh);
  HexMesh result = options.half ? mesh : mirrored(mesh);
  check(result, 2, rim_groups);
  return result;
}

} // namespace rimpact::meshes

#include "meshes/rim_mesh.h"

#include "meshes/mirror.h"
#include "meshes/own_mesh.h"
#include "meshes/plate_section.h"
#include "meshes/slider_section.h"
#include "meshes/touched_places.h"
#include "meshes/units.h"
#include <algorithm>
#include <cmath>

namespace rimpact::meshes {

double plate_cut_radius(const scene::Bearing &bearing) {
  constexpr double cut = 0.44, edge = 0.52; // of shfps-225: 80 mm inside, where nothing moves
  return cut * std::min(1.0, bearing.surface.planar_radius / edge);
}

void add_rim(HexMesh &mesh, const scene::Bearing &bearing, const MeshOrder &order) {
  const double h = size_factor(order.level);
  const double wall = bearing.wall_radius();
  const PlaceSizes sizes{10 * mm * h / wall, 20 * mm / wall, order.sector_half_angle, 0.45 * h};
  const std::vector<Quad9> section =
      plate_and_rim(bearing, {plate_cut_radius(bearing), 60 * mm * h, plate_layers(bearing, h)}, h);
  for (const RimArc &arc : rim_arcs(from_the_first(order.directions), sizes, order.half)) {
    const auto end = [&](bool at_symmetry) -> std::optional<Surface> {
      if (arc.closed) return {};
      return at_symmetry ? Surface::symmetry : Surface::sector_end;
    };
    Body(mesh).revolve(section, arc.angles, 0.0, end(arc.from_symmetry), end(arc.to_symmetry));
  }
}

void flatten(HexMesh &mesh) {
  for (auto &node : mesh.nodes)
    if (std::abs(node[1]) < 1e-12) node[1] = 0;
}

HexMesh rim_mesh(const scene::Bearing &bearing, const MeshOrder &order) {
  if (order.own.any())
    return own_mesh(
        order.own, bearing,
        {{Volume::plate, Volume::rim, Volume::upper_slider}, rim_groups, bearing.lateral_capacity(), order.half});
  HexMesh mesh;
  MeshOrder half = order;
  half.half = true;
  add_rim(mesh, bearing, half);
  add_slider(mesh, bearing, size_factor(order.level), bearing.lateral_capacity());
  flatten(mesh);
  HexMesh result = order.half ? mesh : mirrored(mesh);
  check(result, 2, rim_groups);
  return result;
}

} // namespace rimpact::meshes

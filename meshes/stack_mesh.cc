#include "meshes/stack_mesh.h"

#include "meshes/mirror.h"
#include "meshes/own_mesh.h"
#include "meshes/pad_and_foot.h"
#include "meshes/plate_disc.h"
#include "meshes/rim_mesh.h"
#include "meshes/slider_section.h"
#include "meshes/touched_places.h"
#include <cmath>

namespace rimpact::meshes {
namespace {

void turn(HexMesh &mesh, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (auto &node : mesh.nodes) node = {c * node[0] - s * node[1], s * node[0] + c * node[1], node[2]};
}

/// At rest on the vertex, the first direction at +x.
HexMesh built_in(const scene::Bearing &bearing, const MeshOrder &order) {
  const double h = size_factor(order.level);
  HexMesh mesh;
  if (bearing.has_pad()) add_pad_and_foot(mesh, bearing, h);
  add_slider(mesh, bearing, h, 0.0, from_the_first(order.directions));
  if (order.whole_plate) add_whole_plate(mesh, bearing, order);
  flatten(mesh);
  if (!order.half) mesh = mirrored(mesh);
  if (order.rim && !order.whole_plate) add_rim(mesh, bearing, order);
  return mesh;
}

/// Each with its rim.
int pieces_of_plate(const MeshOrder &order) {
  if (order.whole_plate) return 1;
  return order.rim ? rim_arcs(from_the_first(order.directions),
                              {1, 0.5 * order.sector_half_angle, order.sector_half_angle, 1}, false)
                         .size()
                   : 0;
}

HexMesh drawn(const scene::Bearing &bearing, const MeshOrder &order, const std::vector<Surface> &groups) {
  OwnMeshNeed need{
      {Volume::pad, Volume::foot, Volume::upper_slider}, groups, 0.0, order.half, order.directions.size() > 1};
  if (order.rim || order.whole_plate) need.bodies.insert(need.bodies.end(), {Volume::plate, Volume::rim});
  return own_mesh(order.own, bearing, need);
}

} // namespace

HexMesh stack_mesh(const scene::Bearing &bearing, const MeshOrder &order) {
  std::vector<Surface> required{Surface::pad_face, Surface::slider_side, Surface::top};
  if (bearing.has_pad()) required.insert(required.end(), {Surface::foot_cap, Surface::socket});
  if (order.rim || order.whole_plate) required.insert(required.end(), rim_groups.begin(), rim_groups.end());
  if (order.whole_plate) required.push_back(Surface::dish);
  if (bearing.pad_is_seated())
    for (const Surface group : {Surface::pad_top, Surface::foot_seat, Surface::pad_side, Surface::foot_recess})
      required.push_back(group);
  HexMesh result = order.own.any() ? drawn(bearing, order, required) : built_in(bearing, order);
  turn(result, order.directions.front());
  if (order.half) flatten(result);
  const int pieces = bearing.pad_is_seated() ? 3 : bearing.has_pad() ? 2 : 1;
  if (!order.own.any()) check(result, pieces + pieces_of_plate(order), required);
  return result;
}

} // namespace rimpact::meshes

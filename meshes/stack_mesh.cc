#include "meshes/stack_mesh.h"

#include "meshes/mirror.h"
#include "meshes/own_mesh.h"
#include "meshes/pad_and_foot.h"
#include "meshes/slider_section.h"
#include <cmath>

namespace rimpact::meshes {
namespace {

void turn(HexMesh &mesh, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (auto &node : mesh.nodes) node = {c * node[0] - s * node[1], s * node[0] + c * node[1], node[2]};
}

/// At rest on the vertex, the sectors at +x and, where asked for, -x.
HexMesh built_in(const scene::Bearing &bearing, const StackMeshOptions &options) {
  const double h = size_factor(options.level);
  HexMesh mesh;
  add_pad_and_foot(mesh, bearing, h);
  add_slider(mesh, bearing, h, 0.0, options.opposite_rim);
  RimMeshOptions rim;
  rim.level = options.level;
  rim.sector_half_angle = options.sector_half_angle;
  if (options.whole_plate)
    add_whole_plate(mesh, bearing, rim, options.opposite_rim);
  else if (options.rim)
    add_rim(mesh, bearing, rim);
  rim.opposite = true;
  if (options.opposite_rim && !options.whole_plate) add_rim(mesh, bearing, rim);
  flatten(mesh);
  return options.half ? mesh : mirrored(mesh);
}

HexMesh drawn(const scene::Bearing &bearing, const StackMeshOptions &options, const std::vector<Surface> &groups) {
  OwnMeshNeed need{{Volume::pad, Volume::foot, Volume::upper_slider}, groups, 0.0, options.half, options.opposite_rim};
  if (options.plates() > 0) need.bodies.insert(need.bodies.end(), {Volume::plate, Volume::rim});
  return own_mesh(options.own, bearing, need);
}

} // namespace

HexMesh stack_mesh(const scene::Bearing &bearing, const StackMeshOptions &options) {
  std::vector<Surface> required{Surface::pad_face, Surface::foot_cap, Surface::socket, Surface::slider_side, Surface::top};
  if (options.plates() > 0) required.insert(required.end(), rim_groups.begin(), rim_groups.end());
  if (options.whole_plate) required.push_back(Surface::dish);
  HexMesh result = options.own.any() ? drawn(bearing, options, required) : built_in(bearing, options);
  turn(result, options.direction);
  if (options.half) flatten(result);
  if (!options.own.any()) check(result, 2 + options.plates(), required);
  return result;
}

} // namespace rimpact::meshes

#include "meshes/stack_mesh.h"

#include "meshes/mirror.h"
#include "meshes/own_mesh.h"
#include "meshes/pad_and_foot.h"
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
HexMesh built_in(const scene::Bearing &bearing, const StackMeshOptions &options) {
  const double h = size_factor(options.level);
  RimMeshOptions rim;
  rim.level = options.level;
  rim.half = options.half;
  rim.sector_half_angle = options.sector_half_angle;
  rim.directions = options.directions;
  HexMesh mesh;
  add_pad_and_foot(mesh, bearing, h);
  add_slider(mesh, bearing, h, 0.0, folded(from_the_first(options.directions)));
  if (options.whole_plate) add_whole_plate(mesh, bearing, rim);
  flatten(mesh);
  if (!options.half) mesh = mirrored(mesh);
  if (options.rim && !options.whole_plate) add_rim(mesh, bearing, rim);
  return mesh;
}

/// Each with its rim.
int pieces_of_plate(const StackMeshOptions &options) {
  if (options.whole_plate) return 1;
  return options.rim ? rim_arcs(from_the_first(options.directions),
                                {1, 0.5 * options.sector_half_angle, options.sector_half_angle, 1}, false)
                           .size()
                     : 0;
}

HexMesh drawn(const scene::Bearing &bearing, const StackMeshOptions &options, const std::vector<Surface> &groups) {
  OwnMeshNeed need{
      {Volume::pad, Volume::foot, Volume::upper_slider}, groups, 0.0, options.half, options.directions.size() > 1};
  if (options.rim || options.whole_plate) need.bodies.insert(need.bodies.end(), {Volume::plate, Volume::rim});
  return own_mesh(options.own, bearing, need);
}

} // namespace

HexMesh stack_mesh(const scene::Bearing &bearing, const StackMeshOptions &options) {
  std::vector<Surface> required{Surface::pad_face, Surface::foot_cap, Surface::socket, Surface::slider_side,
                                Surface::top};
  if (options.rim || options.whole_plate) required.insert(required.end(), rim_groups.begin(), rim_groups.end());
  if (options.whole_plate) required.push_back(Surface::dish);
  HexMesh result = options.own.any() ? drawn(bearing, options, required) : built_in(bearing, options);
  turn(result, options.directions.front());
  if (options.half) flatten(result);
  if (!options.own.any()) check(result, 2 + pieces_of_plate(options), required);
  return result;
}

} // namespace rimpact::meshes

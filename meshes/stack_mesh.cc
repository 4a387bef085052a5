#include "meshes/stack_mesh.h"

#include "meshes/mirror.h"
#include "meshes/pad_and_foot.h"
#include "meshes/slider_section.h"
#include <cmath>

namespace rimpact::meshes {
namespace {

void turn(HexMesh &mesh, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (auto &node : mesh.nodes) node = {c * node[0] - s * node[1], s * node[0] + c * node[1], node[2]};
}

} // namespace

HexMesh stack_mesh(const scene::Bearing &bearing, const StackMeshOptions &options) {
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
  HexMesh result = options.half ? mesh : mirrored(mesh);
  turn(result, options.direction);
  if (options.half) flatten(result);
  std::vector<Surface> required{Surface::pad_face, Surface::foot_cap, Surface::socket, Surface::slider_side, Surface::top};
  const int plates = options.whole_plate ? 1 : options.rim + options.opposite_rim;
  if (plates > 0) required.insert(required.end(), rim_groups.begin(), rim_groups.end());
  check(result, 2 + plates, required);
  return result;
}

} // namespace rimpact::meshes

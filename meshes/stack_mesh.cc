#include "meshes/stack_mesh.h"

#include "meshes/mirror.h"
#include "meshes/pad_and_foot.h"
#include "meshes/slider_section.h"

namespace rimpact::meshes {

HexMesh stack_mesh(const scene::Bearing &bearing, const StackMeshOptions &options) {
  const double h = size_factor(options.level);
  HexMesh mesh;
  add_pad_and_foot(mesh, bearing, h);
  add_slider(mesh, bearing, h, 0.0);
  if (options.with_rim) {
    RimMeshOptions rim;
    rim.level = options.level;
    add_rim(mesh, bearing, rim);
  }
  flatten(mesh);
  HexMesh result = options.half ? mesh : mirrored(mesh);
  std::vector<Surface> required{Surface::pad_face, Surface::foot_cap, Surface::socket, Surface::slider_side, Surface::top};
  if (options.with_rim) required.insert(required.end(), rim_groups.begin(), rim_groups.end());
  check(result, options.with_rim ? 3 : 2, required);
  return result;
}

} // namespace rimpact::meshes

/// The solids of rung rim: a sector of the rim with the plate below it, and the upper slider with
/// its socket cavity, in the position of first touch. Frame: the plate's, rotated so that the touched side is
/// +x; the slider's axis stands at x = L_c, its bottom at slider.bottom + lift(L_c).
#pragma once
#include "meshes/hex_mesh.h"
#include "scene/bearing.h"
#include "scene/own_mesh_settings.h"
#include <cmath>

namespace rimpact::meshes {

struct RimMeshOptions {
  int level = 1;                  ///< 1 | 2 | 3: every size divided by 1.5 a level
  bool half = true;               ///< y >= 0 only, with the group `symmetry` on y = 0
  double sector_half_angle = 1.0; ///< of rim and plate [rad]; the ends carry `sector_end`
  std::vector<double> directions{
      0};                           ///< of the places touched, the first at +x [rad]; a half model's are 0 and pi apart
  double plate_inner_radius = 0.44; ///< where the plate is cut [m]; the cut carries `sector_end`
  scene::OwnMesh own = {};          ///< drawn elsewhere; then only `half` counts
};
HexMesh rim_mesh(const scene::Bearing &bearing, const RimMeshOptions &options);
/// What a mesh of rim and slider must carry.
inline const std::vector<Surface> rim_groups{Surface::rim_wall, Surface::slider_side, Surface::top, Surface::fixed};
/// Sizes of a level over those of level 1.
inline double size_factor(int level) {
  return std::pow(1.5, -(level - 1));
}
/// The sectors alone, added to a mesh.
void add_rim(HexMesh &mesh, const scene::Bearing &bearing, const RimMeshOptions &options);
/// The half y >= 0 of the whole plate with the same sectors of the rim on it, and those of their images (rung full);
/// fine under the path along x.
void add_whole_plate(HexMesh &mesh, const scene::Bearing &bearing, const RimMeshOptions &options);
/// Puts nodes that rounding moved off the plane of symmetry back on it.
void flatten(HexMesh &mesh);

} // namespace rimpact::meshes

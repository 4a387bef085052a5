/// The solids of rung rigid-dish (docs/theory/rungs.md): pad, foot and upper slider at rest on the vertex and, where a
/// scene asks for it, rim sectors with the plate below them. Frame: the plate's. The slider is finest towards the
/// directions in which it may meet the rim.
#pragma once
#include "meshes/rim_mesh.h"

namespace rimpact::meshes {

struct StackMeshOptions {
  int level = 1;                  ///< 1 | 2 | 3: every size divided by 1.5 a level
  bool half = true;               ///< y >= 0 only, with the group `symmetry` on y = 0
  bool rim = false;               ///< sectors of rim and plate about the directions
  double sector_half_angle = 1.0; ///< of each [rad]
  bool whole_plate = false;       ///< the dish is meshed as well, from its middle (rung full)
  std::vector<double> directions{
      0}; ///< in which slider and rim may meet, the first the mesh's own x axis [rad]; a half model takes 0 and pi
  scene::OwnMesh own = {}; ///< drawn elsewhere; then `half`, `whole_plate` and `directions` count
};
/// Groups: pad_face, foot_cap, socket, slider_side, top, and with a rim those of rim_mesh. Pad and foot are one
/// connected piece (tied); the slider's socket lies on the foot's cap.
HexMesh stack_mesh(const scene::Bearing &bearing, const StackMeshOptions &options);

} // namespace rimpact::meshes

/// The solids of rung R2 (DESIGN 1): pad, foot and upper slider at rest on the vertex and, where a scene asks for
/// it, the rim sector with the plate below it. Frame: the plate's, the sector's middle on +x. The meshes of the
/// slider and the foot are finest towards +x.
#pragma once
#include "meshes/rim_mesh.h"

namespace rimpact::meshes {

struct StackMeshOptions {
  int level = 1;         ///< 1 | 2 | 3: every size divided by 1.5 a level
  bool half = true;      ///< y >= 0 only, with the group `symmetry` on y = 0
  bool with_rim = false; ///< a sector of RimMeshOptions' size
};
/// Groups: pad_face, foot_cap, socket, slider_side, top, and with a rim those of rim_mesh. Pad and foot are one
/// connected piece (tied); the slider's socket lies on the foot's cap.
HexMesh stack_mesh(const scene::Bearing &bearing, const StackMeshOptions &options);

} // namespace rimpact::meshes

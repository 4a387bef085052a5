/// The solids of rung R2 (DESIGN 1): pad, foot and upper slider at rest on the vertex and, where a scene asks for
/// it, rim sectors with the plate below them. Frame: the plate's. Slider, foot and first sector are finest towards
/// `direction`.
#pragma once
#include "meshes/rim_mesh.h"

namespace rimpact::meshes {

struct StackMeshOptions {
  int level = 1;         ///< 1 | 2 | 3: every size divided by 1.5 a level
  bool half = true;      ///< y >= 0 only, with the group `symmetry` on y = 0
  bool rim = false;      ///< a sector of rim and plate, its middle at `direction`
  bool opposite_rim = false; ///< and a second one on the other side
  double sector_half_angle = 1.0; ///< of each [rad]
  bool whole_plate = false;       ///< the dish is meshed as well, from its middle (rung R3)
  double direction = 0;           ///< [rad]; a half model takes 0 or pi
  scene::OwnMesh own = {};        ///< drawn elsewhere; then `half`, `whole_plate`, `opposite_rim` and `direction` count

  int plates() const { return whole_plate ? 1 : rim + opposite_rim; } ///< pieces of the plate, each with its rim
};
/// Groups: pad_face, foot_cap, socket, slider_side, top, and with a rim those of rim_mesh. Pad and foot are one
/// connected piece (tied); the slider's socket lies on the foot's cap.
HexMesh stack_mesh(const scene::Bearing &bearing, const StackMeshOptions &options);

} // namespace rimpact::meshes

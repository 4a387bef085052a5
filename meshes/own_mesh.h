/// A drawn bearing made fit for a rung: the bodies it needs, checked against the bearing's dimensions, put in the
/// rung's position, its contact surfaces moved onto the exact ones.
#pragma once
#include "meshes/hex_mesh.h"
#include "scene/bearing.h"
#include "scene/own_mesh_settings.h"

namespace rimpact::meshes {

struct OwnMeshNeed {
  std::vector<Volume> bodies;
  std::vector<Surface> groups;
  double travel = 0;       ///< of the slider's axis along +x [m]: 0, at rest, or L_c, at first touch
  bool half = true;        ///< y >= 0; a drawn half is mirrored for a whole model
  bool both_sides = false; ///< a rim wall at -x too
};
/// Bodies drawn but not needed are left out. Throws DataError: a group that is missing, bodies welded together or tied
/// ones apart, a unit or dimension that is not the bearing's (with both numbers), an inverted cell.
HexMesh own_mesh(const scene::OwnMesh &own, const scene::Bearing &bearing, const OwnMeshNeed &need);

} // namespace rimpact::meshes

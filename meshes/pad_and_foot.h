/// The pad and the foot it is seated in: bodies of revolution about the slider's axis, tied on the seat.
#pragma once
#include "meshes/section.h"
#include "scene/bearing.h"

namespace rimpact::meshes {

/// Adds the half y >= 0, upright, its sliding face's middle at the vertex; h scales every size (1 at level 1).
/// Pad and seat share their nodes; the recess's wall does not touch the pad.
void add_pad_and_foot(HexMesh &mesh, const scene::Bearing &bearing, double h);

} // namespace rimpact::meshes

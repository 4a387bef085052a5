/// The pad and the foot it is seated in: bodies of revolution about the slider's axis.
#pragma once
#include "meshes/section.h"
#include "scene/bearing.h"

namespace rimpact::meshes {

/// Adds the half y >= 0, upright, its sliding face's middle at the vertex; h scales every size (1 at level 1).
/// A tied pad and its seat share their nodes. A frictional one has its own, with the groups pad_top on foot_seat and
/// pad_side within foot_recess. The recess's wall never shares a node with the pad.
void add_pad_and_foot(HexMesh &mesh, const scene::Bearing &bearing, double h);

} // namespace rimpact::meshes

/// The upper slider with its socket cavity and rounded lower edge, at the position of first touch.
#pragma once
#include "meshes/section.h"
#include "scene/bearing.h"

namespace rimpact::meshes {

/// Adds the half y >= 0; h scales every size (1 at level 1).
void add_slider(HexMesh &mesh, const scene::Bearing &bearing, double h);

} // namespace rimpact::meshes

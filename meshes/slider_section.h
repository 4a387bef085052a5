/// The upper slider with its socket cavity and rounded lower edge.
#pragma once
#include "meshes/section.h"
#include "scene/bearing.h"

namespace rimpact::meshes {

/// Adds the half y >= 0 at a travel along x [m], lifted as the surface lifts it; h scales every size (1 at level 1).
/// Finest towards +x, or towards both sides.
void add_slider(HexMesh &mesh, const scene::Bearing &bearing, double h, double travel, bool both_sides = false);

} // namespace rimpact::meshes

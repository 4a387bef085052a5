/// The upper slider with its socket cavity and rounded lower edge; of a slider between two dishes the lower half, with
/// its face.
#pragma once
#include "meshes/section.h"
#include "scene/bearing.h"

namespace rimpact::meshes {

/// Adds the half y >= 0 at a travel of what is carried along x [m], lifted as the surface lifts it, or, between two
/// dishes, tilted about the centre of its dish; h scales every size (1 at level 1).
/// Finest at its places (see from_the_first in touched_places.h) and at their images in the plane of the first. Without
/// travel a slider between two dishes is its own image in the plane x = 0 too: its middle plane has pairs of nodes.
void add_slider(HexMesh &mesh, const scene::Bearing &bearing, double h, double travel,
                const std::vector<double> &places = {0.0});

} // namespace rimpact::meshes

/// Where the nodes of a drawn bearing's groups have to lie. Private to the meshes.
#pragma once
#include "meshes/hex_mesh.h"
#include "scene/bearing.h"

namespace rimpact::meshes {

/// Moves nodes of the groups with an exact surface onto it, the slider's axis standing at x = travel. Throws DataError,
/// opening with `file`, for a node farther off than 0.2 mm (middles of straight cells, and all nodes of divided
/// tetrahedra: what their chord leaves).
void fit_to_surfaces(HexMesh &mesh, const scene::Bearing &bearing, double travel, const std::string &file,
                     bool divided = false);

} // namespace rimpact::meshes

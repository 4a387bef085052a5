/// The whole disc of the plate as hexahedra.
#pragma once
#include "meshes/rim_mesh.h"

namespace rimpact::meshes {

/// The half y >= 0 of the whole plate with the same sectors of the rim on it, and those of their images (rung full);
/// fine under the path along x.
void add_whole_plate(HexMesh &mesh, const scene::Bearing &bearing, const MeshOrder &order);

} // namespace rimpact::meshes

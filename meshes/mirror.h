/// The whole of a half mesh.
#pragma once
#include "meshes/hex_mesh.h"

namespace rimpact::meshes {
/// y -> -y, merged along y = 0; the symmetry group disappears.
HexMesh mirrored(const HexMesh &half);
} // namespace rimpact::meshes

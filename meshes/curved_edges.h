/// Straight cells of bodies of revolution made round. Private to the meshes.
#pragma once
#include "meshes/hex_mesh.h"

namespace rimpact::meshes {

/// Edges whose ends lie at one height and radius about their body's axis (plate and rim: the origin's; others: x =
/// travel) follow that circle, cells' faces and centres with them; not on an outer wall with corners, of a square plate
/// say. Moving the nodes of a wall alone would fold the thin cells behind it.
void curve_edges(HexMesh &mesh, double travel);

} // namespace rimpact::meshes

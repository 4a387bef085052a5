/// The solids of rung rim: a sector of the rim with the plate below it, and the upper slider with
/// its socket cavity, in the position of first touch. Frame: the plate's, rotated so that the touched side is
/// +x; the slider's axis stands at x = L_c, its bottom at slider.bottom + lift(L_c).
#pragma once
#include "meshes/hex_mesh.h"
#include "meshes/mesh_order.h"
#include "scene/bearing.h"

namespace rimpact::meshes {

/// Where the plate below the rim is cut [m], inside the dish's edge; the cut carries `sector_end`.
double plate_cut_radius(const scene::Bearing &bearing);

HexMesh rim_mesh(const scene::Bearing &bearing, const MeshOrder &order);
/// What a mesh of rim and slider must carry.
inline const std::vector<Surface> rim_groups{Surface::rim_wall, Surface::slider_side, Surface::top, Surface::fixed};
/// The sectors alone, added to a mesh.
void add_rim(HexMesh &mesh, const scene::Bearing &bearing, const MeshOrder &order);
/// Puts nodes that rounding moved off the plane of symmetry back on it.
void flatten(HexMesh &mesh);

} // namespace rimpact::meshes

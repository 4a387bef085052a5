/// The solids of rung rigid-dish (docs/theory/rungs.md): pad, foot and upper slider at rest on the vertex and, where a
/// scene asks for it, rim sectors with the plate below them. Frame: the plate's. The slider is finest towards the
/// directions in which it may meet the rim. Between two dishes the one below is meshed, and the slider to its middle
/// plane, which is `top`.
#pragma once
#include "meshes/hex_mesh.h"
#include "meshes/mesh_order.h"
#include "scene/bearing.h"

namespace rimpact::meshes {

/// Groups: pad_face, foot_cap, socket, slider_side, top, and with a rim those of rim_mesh. A tied pad and its
/// foot are one connected piece; a frictional one has pad_top, foot_seat, pad_side and foot_recess. The slider's socket
/// lies on the foot's cap. A slider between two dishes has pad_face, slider_side and top alone.
HexMesh stack_mesh(const scene::Bearing &bearing, const MeshOrder &order);

} // namespace rimpact::meshes

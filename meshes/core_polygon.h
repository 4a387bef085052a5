/// Quadrilaterals that fill the polygon in the middle of the slider's core, by gmsh.
#pragma once
#include "meshes/section.h"

namespace rimpact::meshes {

/// `polygon`: the nodes of its outer side, corners and the middles of the edges between them. It is closed by the
/// diameter, or, of a quarter, by the two edges that meet in the centre. Size: wanted edge length [m]. Edges are
/// straight.
std::vector<Quad9> polygon_quads(const std::vector<Point2> &polygon, bool quarter, double size);

} // namespace rimpact::meshes

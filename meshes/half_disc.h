/// Quadrilaterals filling a half disc, by gmsh: the core of the slider, whose rim nodes must meet given
/// angles.
#pragma once
#include "meshes/section.h"

namespace rimpact::meshes {

/// Half disc x^2 + y^2 <= radius^2, y >= 0: one ring of cells along the arc, and a polygon inside it that
/// gmsh fills. (Without the ring a cell may have two edges on the smooth arc: a flat corner.) The arc has
/// nodes exactly at `angles` (0 .. pi, an even number of intervals, each odd-numbered angle midway between
/// its neighbours). Where that leaves a cell nearly flat or drawn out, the polygon's corners spread more
/// evenly and its cells get finer, as far as serves. Size: wanted edge length inside [m]. Edges on y = 0 carry the
/// group `symmetry`.
std::vector<Quad9> half_disc(double radius, const std::vector<double> &angles, double size);
/// The same, its own image in the plane x = 0, from the angles of the quarter x >= 0 (0 .. pi / 2).
std::vector<Quad9> symmetric_half_disc(double radius, const std::vector<double> &quarter, double size);

/// Angles as half_disc wants them: every interval halved.
std::vector<double> halved(const std::vector<double> &lines);

} // namespace rimpact::meshes

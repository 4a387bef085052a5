/// A sliding surface through a table of radii and heights, and the table's file.
#pragma once
#include "scene/surface.h"
#include <memory>
#include <string>

namespace rimpact::scene {

/// Cubic spline through a table's rows, horizontal at the vertex, its last two pieces one cubic (not-a-knot):
/// exact for cubics, fourth order in the rows' distance. Curvature is as good as the heights' digits: an
/// error d of heights at a distance h of rows becomes up to 12 d/h^2. Throws InputError for rows that make no
/// table.
std::unique_ptr<SlidingSurface> make_table(const SurfaceSpec &spec);
/// Fills the table from a CSV file with the columns radius_mm and height_mm (comments with #). Throws
/// DataError naming file and line.
void read_surface_table(const std::string &path, SurfaceSpec &spec);

} // namespace rimpact::scene

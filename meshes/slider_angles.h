/// Angles at which the slider's grid has its lines [rad], finest at its places; in equal pairs, because gmsh halves
/// every edge of the core's plan.
#pragma once
#include <vector>

namespace rimpact::meshes {

/// From 0 to pi. `places`: see from_the_first in touched_places.h; h scales every size (1 at level 1).
std::vector<double> half_angles(const std::vector<double> &places, double radius, double h);
/// From 0 to pi / 2, for the places and their images in the plane x = 0.
std::vector<double> quarter_angles(const std::vector<double> &places, double radius, double h);
/// Of a quarter the half, with the images of its lines.
std::vector<double> with_image(const std::vector<double> &quarter);

} // namespace rimpact::meshes

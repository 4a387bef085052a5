/// Directions in which slider and rim meet, and grids of angles that are fine there. An angle of 0 is the first
/// place's; the others are counted from it.
#pragma once
#include "meshes/section.h"

namespace rimpact::meshes {

/// Of a graded grid: the size at a place and as far as `zone` from it, growing to `coarse` at `reach` [rad].
struct PlaceSizes {
  double fine, zone, reach, coarse;
  /// Lines nearer than this leave a sliver between them.
  double apart() const { return 0.5 * fine; }
  /// A shorter stretch has no line of its own at `zone`, or at `reach`.
  double past_zone() const { return zone + apart(); }
  double past_reach() const { return reach + 0.25 * coarse; }
};

/// From the first, in [0, 2 pi), ascending.
std::vector<double> from_the_first(const std::vector<double> &directions);
/// Of places and their images in the plane of the first: in [0, pi], ascending. What lies nearer than `apart` to an end
/// or to the place before is that one: a grid has a line at each, and no cell may be a sliver between two.
std::vector<double> folded(const std::vector<double> &places, double apart);

/// Of a grid from the first to the last of ascending places.
std::vector<Anchor> anchors_at(const std::vector<double> &places, const PlaceSizes &sizes);

/// An arc of the rim: lines of its grid; whether it is cut at a plane of symmetry, or has no end at all.
struct RimArc {
  std::vector<double> angles;
  bool from_symmetry = false, to_symmetry = false, closed = false;
};
/// As far as sizes.reach beyond each place; arcs that would overlap are one. half: places at 0 and pi only, y >= 0
/// kept.
std::vector<RimArc> rim_arcs(const std::vector<double> &places, const PlaceSizes &sizes, bool half);

} // namespace rimpact::meshes

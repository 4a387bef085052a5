/// The cap of a sphere.
#pragma once
#include <cmath>

namespace rimpact::scene {

/// How far a sphere of radius R has risen above its vertex at the radius r, 0 <= r <= R [m].
inline double cap_height(double R, double r) {
  return R - std::sqrt(R * R - r * r);
}

} // namespace rimpact::scene

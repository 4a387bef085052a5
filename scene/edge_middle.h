/// The rounding of a slider's edge between two dishes.
#pragma once
#include "scene/bearing.h"
#include <cmath>

namespace rimpact::scene {

/// The middle of the rounding from the dish's centre in the slider's own frame: outwards and down [m]. The rounding is
/// tangent to the side and to the sliding face.
struct EdgeMiddle {
  double out, down;
  explicit EdgeMiddle(const Bearing &b)
      : out(b.slider.diameter / 2 - b.slider.edge_radius),
        down(std::sqrt(std::pow(b.surface.R0 - b.slider.edge_radius, 2) - out * out)) {}
};

} // namespace rimpact::scene

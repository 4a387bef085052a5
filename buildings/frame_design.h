/// Yield moments of a frame's sections by equivalent lateral forces.
#pragma once
#include "buildings/plane_frame.h"

namespace rimpact::buildings {

/// Sections without a yield moment get the largest end moment of their members, elastic, base held: that of the weights
/// with that of the lateral forces, whichever their sign, times overstrength.
void design_yield_moments(Frame &frame, const FrameDesign &design, double gravity);

} // namespace rimpact::buildings

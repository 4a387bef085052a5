/// Whether every key is within its bounds.
#pragma once
#include "scene/keys.h"

namespace rimpact::scene {

/// Throws InputError for the first value outside its range: "rim.height_mm -3 must be > 0".
void check_ranges(const Bearing &bearing);
void check_ranges(const Scene &scene); ///< its settings, not its bearing

} // namespace rimpact::scene

/// Which rim a fitted law belongs to: a short name made of everything that shapes the force of an impact.
#pragma once
#include "scene/bearing.h"
#include <string>

namespace rimpact::scene {

/// Sixteen hexadecimal digits of surface, slider, rim, plate, steel and the friction of the walls. The bearing's name,
/// its pad, foot and Ertalyte, and what the steel is trusted to bear do not enter.
std::string rim_identity(const Bearing &bearing);

/// The values behind it, one a line as `slider.diameter_mm = 225`.
std::string rim_values(const Bearing &bearing);
/// In what two such texts differ: "slider.diameter_mm 225 and 220, rim.height_mm 30 and 25".
std::string rim_differences(const std::string &a, const std::string &b);

/// The same of everything a bearing is made of, pad, foot and Ertalyte and all friction too: what a run with its dish
/// depends on. Not its name, and not what the steel is trusted to bear.
std::string bearing_identity(const Bearing &bearing);

} // namespace rimpact::scene

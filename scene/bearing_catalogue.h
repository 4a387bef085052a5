/// Built-in bearings.
#pragma once
#include "scene/bearing.h"

namespace rimpact::scene {

/// Built-in bearings: shfps-225 (default) and fps-225 (a = R0). Throws InputError with the nearest name.
Bearing builtin_bearing(const std::string &name);
std::vector<std::string> builtin_bearing_names();

} // namespace rimpact::scene

/// Built-in bearings.
#pragma once
#include "scene/bearing.h"

namespace rimpact::scene {

/// Built-in bearings: shfps-225 is the default. Throws InputError with the nearest name.
Bearing builtin_bearing(const std::string &name);
std::vector<std::string> builtin_bearing_names();

} // namespace rimpact::scene

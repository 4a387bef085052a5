/// What is allowed but looks like a slip of units or of the decimal point, or belongs to another bearing: said before a
/// scene is run.
#pragma once
#include "scene/scene.h"

namespace rimpact::scene {

/// Sentences with key, value and what it is compared with; empty when nothing looks odd.
/// A load that is not read (a building's bearings carry shares of it) is not looked at.
std::vector<std::string> doubts(const Scene &scene, bool load_is_read = true);

} // namespace rimpact::scene

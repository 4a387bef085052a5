/// What is allowed but looks like a slip of units or of the decimal point: said before a scene is run.
#pragma once
#include "scene/scene.h"

namespace rimpact::scene {

/// Sentences with key, value and what it is compared with; empty when nothing looks odd.
std::vector<std::string> doubts(const Scene &scene);

} // namespace rimpact::scene

/// Built-in scenes of the double concave models.
#pragma once
#include "scene/scene_catalogue.h"
#include <vector>

namespace rimpact::scene {

std::vector<BuiltinScene> double_concave_scenes();

} // namespace rimpact::scene

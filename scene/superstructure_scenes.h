/// Built-in scenes with a superstructure.
#pragma once
#include "scene/scene_catalogue.h"
#include <vector>

namespace rimpact::scene {

std::vector<BuiltinScene> superstructure_scenes();

} // namespace rimpact::scene

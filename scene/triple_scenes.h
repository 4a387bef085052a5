/// Built-in scenes of the triple friction pendulum.
#pragma once
#include "scene/scene_catalogue.h"
#include <vector>

namespace rimpact::scene {

std::vector<BuiltinScene> triple_scenes();

} // namespace rimpact::scene

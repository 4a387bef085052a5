/// Built-in scenes of the double concave models.
#pragma once
#include "scene/scene_catalogue.h"
#include <vector>

namespace rimpact::scene {

std::vector<BuiltinScene> double_concave_scenes();
/// [reduced] and [isolator] of the comparison in thesis 4.3: LIR-DCFP of 25 cm.
std::string isolators_of_43();

} // namespace rimpact::scene

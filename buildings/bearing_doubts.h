/// What is to be doubted of the impact elements of a building's bearings, each under its own weight at rest.
#pragma once
#include "scene/scene.h"

namespace rimpact::buildings {

/// `bearings` as bearings_of gives them, `reactions` at rest [N], in the same order. Of bearings alike the lightest and
/// the heaviest loaded stand for the others. Sentences "bearing 3 (25483 kg): ...", none twice.
std::vector<std::string> doubts_of_elements(const std::vector<scene::Scene> &bearings,
                                            const std::vector<double> &reactions);

} // namespace rimpact::buildings

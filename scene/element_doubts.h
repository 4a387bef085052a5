/// Doubts of the impact element.
#pragma once
#include "scene/doubts.h"

namespace rimpact::scene {

/// What to say of an impact element that is not this bearing's: the thesis's pair on another bearing or mass, a
/// calibration of another rim or of another mass. Empty where nothing reads the element: FE needs none, nor do static
/// paths or k_i = 0.
std::vector<std::string> doubts_of_element(const Scene &scene);
/// Whether the thesis's pair is this scene's: the dish, rim and steel of shfps-225 and its mass, to 1 %.
bool published_pair_applies(const Scene &scene);
/// Whether the element's numbers are the defaults of its law, the thesis's pair for the laws with a dashpot.
bool has_default_element(const Scene &scene);
/// "k_i = 450000 kN/m, e = 0.65", or the numbers of another law, as the scene has them.
std::string numbers_of_element(const Scene &scene);
/// The same of a triple pendulum's inner rims that have their own law.
std::string numbers_of_inner_element(const Scene &scene);

} // namespace rimpact::scene

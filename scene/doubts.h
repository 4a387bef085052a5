/// What is allowed but looks like a slip of units or of the decimal point, or belongs to another bearing: said before a
/// scene is run.
#pragma once
#include "scene/scene.h"

namespace rimpact::scene {

/// Sentences with key, value and what it is compared with; empty when nothing looks odd.
/// A load that is not read (a building's bearings carry shares of it) is not looked at.
std::vector<std::string> doubts(const Scene &scene, bool load_is_read = true);

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

} // namespace rimpact::scene

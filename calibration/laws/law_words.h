/// A fitted law in words: its numbers, and whether they hold for one mass only.
#pragma once
#include "scene/scene.h"
#include <string>
#include <vector>

namespace rimpact::calibration {

/// Whether the element of `settings` changes with the supported mass, as one does whose dashpot is 2 xi sqrt(k_i m):
/// its numbers belong to the mass. Otherwise they belong to the rim.
bool belongs_to_mass(const scene::ReducedSettings &settings);

/// Every number that the scene's impact law reads, to five figures: "k_i = 65733 kN/m, e = 0.11952".
std::string numbers_in_words(const scene::Scene &scene);

/// "the constant pair k_i = ..., e = ... of law signed, for a supported mass of 86952 kg", or "the law elastoplastic
/// (k_i = ...)".
std::string law_in_words(const scene::Scene &scene);

/// "elastoplastic: held hardening_exponent at 0.75 and unloading_exponent at 0.5, WHY." at the scene's values, which
/// are what a fit leaves alone. Empty without exponents.
std::string held_in_words(const std::vector<std::string> &exponents, const scene::Scene &scene, const std::string &law,
                          const std::string &why);

} // namespace rimpact::calibration

/// Bearings of rigid bodies with published dimensions, by name: `isolator.name`.
#pragma once
#include "scene/isolator.h"
#include <vector>

namespace rimpact::scene {

inline constexpr const char *default_triple = "tfp-fenz-2008"; ///< taken where a triple pendulum is not named

std::vector<std::string> builtin_isolator_names();
/// Throws InputError naming the known ones.
Isolator builtin_isolator(const std::string &name);
/// Throws InputError where a file, a scene or a dish is asked for and the name is one of these.
void refuse_isolator(const std::string &where);
/// Where its numbers come from, and which are assumptions.
std::string isolator_source(const std::string &name);

} // namespace rimpact::scene

/// Scenes and bearings as TOML.
#pragma once
#include "scene/scene.h"

namespace rimpact::scene {

std::string to_toml(const Bearing &bearing);
/// As resolved: every default written out, round-trips through parse_scene. Assumptions carry the word as comment.
std::string to_toml(const Scene &scene);

} // namespace rimpact::scene

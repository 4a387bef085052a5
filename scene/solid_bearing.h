/// Which scenes have no bearing for the finite elements.
#pragma once
#include "scene/scene.h"
#include <optional>
#include <string>

namespace rimpact::scene {

/// Why `taker` ("main takes", "the finite elements take") finds none in [bearing]: a sentence that names the ways out.
/// Nothing but for scenes of rigid bodies, whose bearing is their [isolator].
std::optional<std::string> without_solid_bearing(const Scene &scene, const std::string &taker);

} // namespace rimpact::scene

/// What is odd about the records that move a scene.
#pragma once
#include "scene/scene.h"
#include <string>
#include <vector>

namespace rimpact::scene {

/// A sentence each: a vertical record along x or y, a horizontal one along z, one component along two axes, components
/// of two stations. Then what is odd about a record's own numbers (io/records/record_doubts.h). Records of unknown
/// direction, and those that are not there any more, say nothing.
void doubt_records(const Scene &scene, std::vector<std::string> &found);

} // namespace rimpact::scene

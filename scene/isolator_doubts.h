/// Doubts of a bearing of rigid bodies.
#pragma once
#include "scene/scene.h"

namespace rimpact::scene {

/// What to say of plates, or of a triple pendulum's slide plates, whose rims lie in one another at rest by more than
/// 1 mm: no bearing can be built like that. The models know contacts of faces, edges and rims only, and run it.
std::vector<std::string> doubts_of_isolator(const Isolator &isolator, ModelKind model);

} // namespace rimpact::scene

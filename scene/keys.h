/// The keys of scene and bearing files, described once. A new key is one line in bearing_keys.cc,
/// isolator_keys.cc, superstructure.cc or scene_keys.cc.
#pragma once
#include "io/files/key_visitor.h"
#include "scene/scene.h"

namespace rimpact::scene {

void visit(KeyVisitor &visitor, Superstructure &structure); ///< [superstructure]

/// Throws InputError where the bearing lacks what the scene's model uses: nothing of [bearing] for two dishes; dish and
/// L_c where no finite elements can follow (a superstructure, a path on the dish by rung `rim`); else slider and rim,
/// and pad and foot where they are modelled.
void check_bearing(const Scene &scene);

} // namespace rimpact::scene

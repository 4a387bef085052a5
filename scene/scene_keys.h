/// The keys of scene files beside the bearing.
#pragma once
#include "scene/keys.h"

namespace rimpact::scene {

/// [load], [excitation], [model], [reduced], [isolator], [superstructure]
void visit_settings(KeyVisitor &visitor, Scene &scene);
/// Of [reduced] and of the inner rims of a triple pendulum: a rim's law, its numbers, and what they are known for.
void visit(KeyVisitor &visitor, ImpactElement &element);
/// Of [reduced], those of rigid bodies, whose rims have no other name.
void visit(KeyVisitor &visitor, FittedPlates &plates);

} // namespace rimpact::scene

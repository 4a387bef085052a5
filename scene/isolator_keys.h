/// The keys of [isolator].
#pragma once
#include "scene/keys.h"

namespace rimpact::scene {

/// [isolator], as the model reads it; all of it beside "physical", which reads none.
void visit(KeyVisitor &visitor, Isolator &bearing, ModelKind model);

} // namespace rimpact::scene

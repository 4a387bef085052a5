/// The keys of bearing files.
#pragma once
#include "scene/keys.h"

namespace rimpact::scene {

void visit(KeyVisitor &visitor, Bearing &bearing); ///< all but its name

} // namespace rimpact::scene

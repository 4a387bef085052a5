/// The keys of bearing files.
#pragma once
#include "scene/keys.h"

namespace rimpact::scene {

void visit(KeyVisitor &visitor, Bearing &bearing);      ///< all but its name
void visit_steel(KeyVisitor &visitor, Material &steel); ///< [material.steel], or one of a part

} // namespace rimpact::scene

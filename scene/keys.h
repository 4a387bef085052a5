/// The keys of scene and bearing files, described once. A new key is one line in bearing_keys.cc,
/// isolator_keys.cc, superstructure.cc or scene_keys.cc.
#pragma once
#include "files/key_visitor.h"
#include "scene/scene.h"

namespace rimpact::scene {

void visit(KeyVisitor &visitor, Bearing &bearing);      ///< all but its name
void visit_steel(KeyVisitor &visitor, Material &steel); ///< [material.steel], or one of a part
/// [isolator], as the model reads it; all of it beside "physical", which reads none.
void visit(KeyVisitor &visitor, Isolator &bearing, ModelKind model);
void visit(KeyVisitor &visitor, Superstructure &structure); ///< [superstructure]
/// [load], [excitation], [model], [reduced], [isolator], [superstructure]
void visit_settings(KeyVisitor &visitor, Scene &scene);

/// Throws InputError for the first value outside its range: "rim.height_mm -3 must be > 0".
void check_ranges(const Bearing &bearing);
void check_ranges(const Scene &scene); ///< its settings, not its bearing
/// Throws InputError where the bearing lacks what the scene's model uses: nothing of [bearing] for two dishes; dish and
/// L_c where no finite elements can follow (a superstructure, a path on the dish by rung `rim`); else slider and rim,
/// and pad and foot where they are modelled.
void check_bearing(const Scene &scene);

} // namespace rimpact::scene

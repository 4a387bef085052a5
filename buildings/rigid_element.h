/// A bearing of rigid bodies below a building's node, for implicit steps.
#pragma once
#include "buildings/bearing_element.h"

namespace rimpact::buildings {

/// A bearing of rigid bodies (`dcfp`, `lir-dcfp`, `tfp`) under its share of the weight: its top plate moves and turns
/// with the node, whose moments are its contacts' about the plate's vertex. Throws InputError for isolator.space
/// "planar".
std::unique_ptr<BearingElement> rigid_element(const scene::Scene &scene);

} // namespace rimpact::buildings

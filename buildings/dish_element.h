/// A mass's support on one dish with a rim, for implicit steps of a building.
#pragma once
#include "buildings/bearing_element.h"

namespace rimpact::buildings {

/// A dish with rim (`physical`): a slider under the node on unilateral springs of isolator.contact_stiffness a point;
/// no moments. Coulomb's friction has the elastic slip of the rigid bodies' contacts (rigid_body/system.h).
std::unique_ptr<BearingElement> dish_element(const scene::Scene &scene);

} // namespace rimpact::buildings

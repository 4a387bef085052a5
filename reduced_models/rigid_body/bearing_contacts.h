/// Contacts between the bodies of a bearing: sets of points at its joints, rims and stops. SI units.
#pragma once
#include "reduced_models/rigid_body/bearing_parts.h"

namespace rimpact::reduced::rigid {

/// Points of each joint from the ground up, then the walls: of each place around the axis all rims, then stops.
std::vector<Contact> contacts_of(const Parts &parts, const scene::Isolator &bearing);

} // namespace rimpact::reduced::rigid

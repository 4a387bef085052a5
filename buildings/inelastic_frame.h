/// The structure of an inelastic frame in the plane of x and z (thesis 2.5): corotational beam-columns with degrading
/// end sections, so with P-Delta. Floors move in u_x, nodes in u_z; the nodes' turns carry no mass and follow, within
/// the same Newton steps. Damping is that of the elastic frame with its base held. Dofs u_y and r_z stay at rest.
#pragma once
#include "buildings/structure.h"

namespace rimpact::buildings {

/// At rest: the weights are put on in steps, base nodes held; what the sections lose by that is forgotten. Throws
/// InputError for a frame that cannot carry its weight.
std::unique_ptr<Structure> inelastic_structure(const Frame &frame, const BuildingModel &model, double gravity);

} // namespace rimpact::buildings

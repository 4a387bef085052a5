/// A linear building as the structure of implicit steps.
#pragma once
#include "buildings/structure.h"

namespace rimpact::buildings {

/// K and C of a linear building.
std::unique_ptr<Structure> linear_structure(const BuildingModel &model, double gravity);

} // namespace rimpact::buildings

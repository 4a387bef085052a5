/// A scene's building on its bearings, from the ground motion to summary and response.
#pragma once
#include "buildings/frame.h"
#include "reduced_models/physical_model.h"

namespace rimpact::buildings {

/// `bearings` as BuildingDynamics takes them; without `with_response` peaks and impacts only. A slider that leaves its
/// dish gives status "stopped" with the reason.
reduced::ReducedRun simulate(const Frame &frame, const scene::Scene &scene,
                             const std::vector<scene::Bearing> &bearings = {}, bool with_response = true);

} // namespace rimpact::buildings

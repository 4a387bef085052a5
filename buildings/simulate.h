/// A scene's building on its bearings, from the ground motion to summary and response.
#pragma once
#include "buildings/recorder.h"
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"

namespace rimpact::buildings {

struct BuildingResult {
  reduced::ReducedRun run;
  BuildingModel model;
  BuildingTrace trace;
};
/// With response, members' forces and, every `picture_step` seconds (0: none), the building's shape. `bearings` as
/// BuildingDynamics takes them; where one of them is a double concave one, the steps are implicit (implicit_run.h),
/// else by branches (building_run.h). A slider that leaves its dish gives status "stopped" with the reason.
BuildingResult simulate_whole(const Frame &frame, const scene::Scene &scene,
                              const std::vector<scene::Scene> &bearings = {}, double picture_step = 0);

/// The run alone; without `with_response` peaks and impacts only.
reduced::ReducedRun simulate(const Frame &frame, const scene::Scene &scene,
                             const std::vector<scene::Scene> &bearings = {}, bool with_response = true);

} // namespace rimpact::buildings

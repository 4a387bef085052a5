/// What the plans of several rungs are made of. Private to the runner.
#pragma once
#include "fe_contact/runner/plan.h"
#include "scene/response.h"
#include "scene/summary.h"

namespace rimpact::fe {

/// Of a half model: unknowns, seconds a Newton iteration on two cores, memory [B]. The whole model has twice the
/// unknowns and takes about three times as long.
struct MeshCost {
  long dofs;
  double seconds_per_iteration, memory;
};
void add_impacts(Plan &plan, const scene::Summary &scout, const scene::Response &response);
void add_pad_note(Plan &plan, const scene::Scene &scene);

/// Rung rigid-dish (stack_plan.cc): a quasi-static path; a window, pulse or record.
Plan stack_path_plan(const scene::Scene &scene);
Plan stack_motion_plan(const scene::Scene &scene);
/// Impacts, sectors, rest, closest gap of its plan.
void scout_stack(Plan &plan, scene::Scene scene);

} // namespace rimpact::fe

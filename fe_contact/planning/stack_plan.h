/// Plans of the rungs with a stack of pad and socket.
#pragma once
#include "fe_contact/planning/plan_parts.h"

namespace rimpact::planning {

/// Rung rigid-dish (stack_plan.cc): a quasi-static path; a window, pulse or record.
Plan stack_path_plan(const scene::Scene &scene);
Plan stack_motion_plan(const scene::Scene &scene);

} // namespace rimpact::planning

/// Plans of the rungs with a stack of pad and socket.
#pragma once
#include "fe_contact/planning/plan_parts.h"

namespace rimpact::planning {

/// Rung rigid-dish (stack_plan.cc): a quasi-static path; a window, pulse or record.
Plan stack_path_plan(const scene::Scene &scene);
Plan stack_motion_plan(const scene::Scene &scene);
/// Whether a quasi-static path may go beyond the rim: to and fro in its plane, the halves of the slider giving way.
bool goes_into_the_rim(const Plan &plan, const scene::Bearing &bearing);

} // namespace rimpact::planning

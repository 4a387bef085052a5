/// What a reduced run says ahead of a rung with a stack.
#pragma once
#include "fe_contact/planning/plan_parts.h"

namespace rimpact::planning {

/// Impacts, sectors, rest, closest gap of its plan.
void scout_stack(Plan &plan, scene::Scene scene);

} // namespace rimpact::planning

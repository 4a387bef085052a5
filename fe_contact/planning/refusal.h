/// What finite elements do not solve.
#pragma once
#include "fe_contact/planning/plan.h"

namespace rimpact::planning {

/// Why no finite-element rung exists for what the scene models, a sentence; nothing of it can be planned.
std::optional<std::string> beyond_rungs(const scene::Scene &scene);
/// Why this build cannot run the scene by finite elements (rung, kind of excitation, contact), a sentence.
std::optional<std::string> refusal(const scene::Scene &scene);

} // namespace rimpact::planning

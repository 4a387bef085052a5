/// What `rimpact geometry` runs: isolated impacts of a bearing under its load.
#pragma once
#include "app/console/console.h"
#include "app/jobs/given_case.h"

namespace rimpact::app {

/// The bearing and load that are run, with what is to be said of them; warns of it. Throws InputError for --calibration
/// and for keys that the verb does not read.
GivenCase geometry_target(const std::string &where, Console &console);
/// The isolated impact of the bearing under its load; `overrides` of the motion are taken.
scene::Scene window_of(const GivenCase &given, const std::vector<std::string> &overrides);
/// Of a run's summary: of the rim's side, averaged; without places, the largest of any body; 0 where none is known.
double strain_in(const nlohmann::json &summary, const std::string &folder);

} // namespace rimpact::app

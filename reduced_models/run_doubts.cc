#include "reduced_models/run_doubts.h"

#include "responses/limits.h"
#include "scene/doubts.h"

namespace rimpact::reduced {

void add_doubts(const scene::Scene &scene, ReducedRun &run) {
  auto &warnings = run.summary.extra["warnings"] = nlohmann::json::array();
  if (!run.summary.impacts.empty())
    for (const auto &doubt : scene::doubts_of_element(scene)) warnings.push_back(doubt);
  if (run.summary.status == RunStatus::done)
    for (const auto &doubt : {doubt_of_rebound(run.response, run.summary.impacts),
                              doubt_of_ledger(run.summary.energy.value_or(EnergyLedger()))})
      if (doubt) warnings.push_back(*doubt);
  judge(scene, run.summary);
}

} // namespace rimpact::reduced

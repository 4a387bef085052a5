#include "reduced_models/run_doubts.h"

#include "responses/limits.h"
#include "scene/doubts.h"
#include "scene/published_pair.h"
#include <algorithm>

namespace rimpact::reduced {

void add_doubts(const scene::Scene &scene, ReducedRun &run) {
  auto &warnings = run.summary.extra["warnings"] = nlohmann::json::array();
  double fastest = 0;
  for (const auto &impact : run.summary.impacts) fastest = std::max(fastest, impact.approach_speed);
  if (!run.summary.impacts.empty())
    for (const auto &doubt : scene::doubts_of_element(scene)) warnings.push_back(doubt);
  if (std::string doubt = scene::doubt_of_published_pair(scene, fastest); !doubt.empty())
    warnings.push_back(std::move(doubt));
  if (run.summary.status == RunStatus::done)
    for (const auto &doubt : {doubt_of_rebound(run.response, run.summary.impacts),
                              doubt_of_ledger(run.summary.energy.value_or(EnergyLedger()))})
      if (doubt) warnings.push_back(*doubt);
  judge(scene, run.summary);
}

} // namespace rimpact::reduced

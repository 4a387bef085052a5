#include "reduced_models/record/run_doubts.h"

#include "reduced_models/bearings/foot_limit.h"
#include "reduced_models/bearings/rim_curve_file.h"
#include "responses/frame_limits.h"
#include "responses/limits.h"
#include "responses/open_impact.h"
#include "scene/doubts.h"
#include "scene/element_doubts.h"
#include "scene/published_pair.h"
#include <algorithm>

namespace rimpact::reduced {

void add_doubts(const scene::Scene &scene, const Response &response, Summary &summary) {
  auto &warnings = summary.extra["warnings"] = nlohmann::json::array();
  double fastest = 0;
  for (const auto &impact : summary.impacts) fastest = std::max(fastest, impact.approach_speed);
  if (!summary.impacts.empty()) {
    for (const auto &doubt : scene::doubts_of_element(scene)) warnings.push_back(doubt);
    for (const auto &doubt : doubts_of_curve(scene)) warnings.push_back(doubt);
    if (std::string doubt = doubt_of_foot(scene); !doubt.empty()) warnings.push_back(std::move(doubt));
  }
  if (std::string doubt = scene::doubt_of_published_pair(scene, fastest); !doubt.empty())
    warnings.push_back(std::move(doubt));
  const auto pressed = doubt_of_rebound(response, summary.impacts);
  if (summary.status == RunStatus::done)
    for (const auto &doubt : {pressed, doubt_of_ledger(summary.energy.value_or(EnergyLedger()))})
      if (doubt) warnings.push_back(*doubt);
  const auto number = [&](const char *key) {
    const auto found = summary.extra.find(key);
    return found != summary.extra.end() && found->is_number() ? std::optional(found->get<double>()) : std::nullopt;
  };
  if (const auto doubt = doubt_of_frame(number("ductility"), number("peak_drift_m"))) warnings.push_back(*doubt);
  if (pressed) leave_last_impact_open(response, summary);
  judge(scene, summary);
}

} // namespace rimpact::reduced

/// Peak impact force and rebound of each finite-element run beside the reduced model with the fitted and with
/// the published pair.
#pragma once
#include "app/main_jobs.h"
#include <nlohmann/json.hpp>

namespace rimpact::app {

/// From the summaries of DIR/runs, DIR/reduced and DIR/published; null where a run is missing.
nlohmann::json comparison_rows(const std::vector<Job> &jobs, const std::string &folder);
std::string comparison_text(const nlohmann::json &rows);

} // namespace rimpact::app

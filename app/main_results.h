/// What the main job makes of its runs: calibration, reduced runs beside them, comparison, main.json.
#pragma once
#include "app/main_jobs.h"
#include <nlohmann/json.hpp>

namespace rimpact::app {

/// Writes DIR/calibration, DIR/reduced, DIR/published and DIR/main.json; returns the table for the terminal.
std::string make_results(const std::vector<Job> &jobs, const std::string &folder, double seconds,
                         Console &console);

} // namespace rimpact::app

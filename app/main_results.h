/// What the main job makes of its runs: calibration, reduced runs beside them, comparison, main.json.
#pragma once
#include "app/console.h"
#include "app/main_jobs.h"
#include <exception>
#include <nlohmann/json.hpp>

namespace rimpact::app {

struct MainResults {
  nlohmann::json main;        ///< as written to DIR/main.json
  std::string text;           ///< calibration and comparison for the terminal
  std::exception_ptr failure; ///< why there is no calibration, or that its gate was not met
};

/// Writes DIR/calibration, DIR/reduced, DIR/published and DIR/main.json. Runs that touch the rim nowhere are
/// not fitted, which is said; with no history to fit, the windows are. Throws SolverStopped when no run ended
/// well. `laws`: ranked on all runs to fit.
MainResults make_results(const std::vector<Job> &jobs, const std::string &folder,
                         const nlohmann::json &versions, double seconds, const std::vector<std::string> &laws,
                         Console &console);

} // namespace rimpact::app

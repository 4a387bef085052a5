/// What the main job makes of its runs: calibration, reduced runs beside them, comparison, main.json.
#pragma once
#include "app/console/console.h"
#include "app/jobs/main_jobs.h"
#include <exception>
#include <nlohmann/json.hpp>

namespace rimpact::app {

struct MainResults {
  nlohmann::json main;        ///< as written to DIR/main.json
  std::string text;           ///< for the terminal: head, answer, comparison, doubts
  std::exception_ptr failure; ///< why there is no calibration, or that its gate was not met
};

/// What goes into main.json beside the runs.
struct MainContext {
  std::string folder;
  std::vector<std::string> laws = {};     ///< ranked on all runs to fit
  std::vector<std::string> warnings = {}; ///< said before the runs
  nlohmann::json versions = {}, document = {}, until = {};
  double seconds = 0; ///< [s] spent so far
};

/// Writes DIR/calibration, DIR/law, DIR/reduced, DIR/published and DIR/main.json. Runs that touch the rim nowhere are
/// not fitted, which is said; with no history to fit, the windows are. Throws SolverStopped when no run ended
/// well.
MainResults make_results(const MainTarget &target, const std::vector<Job> &jobs, const MainContext &context,
                         Console &console);

} // namespace rimpact::app

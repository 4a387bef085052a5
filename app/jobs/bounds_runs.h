/// SCENE --bounds lower,upper of `reduced` and `building`: the same run with friction at the ends of its range.
#pragma once
#include "app/console/console.h"
#include "responses/summary.h"
#include "scene/bounds.h"
#include <functional>

namespace rimpact::app {

/// --bounds of a verb; empty: not asked for. Words: lower, upper; the nominal run is always made.
CLI::Option *add_bounds_option(CLI::App &verb, std::vector<std::string> &words);

struct BoundsOrder {
  std::vector<std::string> words; ///< of --bounds
  std::string folder;             ///< holds a run folder for each bound, bounds.json and bounds.csv
  bool picture = false;           ///< bounds.png too
};
/// One run into a folder; what it says stays on stderr.
using RunOne = std::function<Summary(const scene::Scene &scene, const std::string &folder)>;
/// Makes the runs, prints their table and writes it. Throws InputError for a word that is no bound, and SolverStopped
/// once all are made where one of them stopped.
void run_bounds(const BoundsOrder &order, const scene::Scene &scene, const RunOne &run, Console &console);

} // namespace rimpact::app

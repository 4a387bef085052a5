/// What `geometry --dry-run` says: the runs, and the time they take.
#pragma once
#include "app/console/console.h"
#include "app/jobs/given_case.h"
#include <optional>

namespace rimpact::app {

struct PlannedRun {
  std::string name;
  double expected; ///< [s]
};
struct RunPlan {
  std::string what, several; ///< "run", "runs"
  int width;                 ///< of the names' column
  std::vector<PlannedRun> runs;
  std::size_t at_once;
  std::optional<double> proof; ///< of a solid run after them [s]; 0: it is not made; none: there is no such run
};
/// As text or JSON.
void print_plan(const GivenCase &given, const RunPlan &plan, const Console &console);

} // namespace rimpact::app

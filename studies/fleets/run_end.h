/// How a run of a fleet ended, as statistics count it.
#pragma once
#include "responses/choices.h"
#include <string>

namespace rimpact::fleets {

/// The column `status` of a fleet's table: of a run, or why there was none.
enum class RowStatus {
  done,
  stopped,
  interrupted,
  refused, ///< the combination is no valid scene
  failed   ///< by a fault, or with a number that is not finite
};
constexpr auto choices(RowStatus) {
  using enum RowStatus;
  return choices_of<RowStatus>(
      {{done, "done"}, {stopped, "stopped"}, {interrupted, "interrupted"}, {refused, "refused"}, {failed, "failed"}});
}

enum class RunEnd {
  done,   ///< its peaks count
  beyond, ///< the slider left its dish, went over its rim, broke it off or overturned, or the frame collapsed: above
          ///< every other run
  without_result ///< refused, failed, or stopped for another reason: not counted
};
/// From the columns `status` (none: no word of the table's) and `reason` of a fleet's table.
RunEnd run_end(std::optional<RowStatus> status, const std::string &reason);

} // namespace rimpact::fleets

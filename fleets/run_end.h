/// How a run of a fleet ended, as statistics count it.
#pragma once
#include <string>

namespace rimpact::fleets {

enum class RunEnd {
  done,          ///< its peaks count
  beyond,        ///< the slider left the dish or the superstructure collapsed: above every other run
  without_result ///< refused, failed, or stopped for another reason: not counted
};
/// From the columns `status` and `reason` of a fleet's table.
RunEnd run_end(const std::string &status, const std::string &reason);

} // namespace rimpact::fleets

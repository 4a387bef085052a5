/// How fast this machine is: seconds a Newton iteration and unknown, kept from finished runs in the user's cache,
/// $XDG_CACHE_HOME/rimpact/machine.json (~/.cache without it). A cache that cannot be read or written is as none.
#pragma once
#include "fe_contact/planning/plan.h"
#include "responses/summary.h"

namespace rimpact::planning {

/// Sets expected_seconds by this machine's own runs of the plan's kind (rung, mesh, half or whole), where there are
/// any, and the range fastest..slowest: the scatter of the iterations (a quarter), with that of the machine's unit, or
/// a factor 2 for a machine not known.
void time_by_this_machine(Plan &plan);

/// Keeps what a run that ended well took. Recent runs count more (a weight of 0.3 for each new one): a busy machine is
/// slower today. Of two that write at the same instant one may be lost.
void remember_times(const Plan &plan, const Summary &summary);

/// "about 1 to 2 min here", "about 30 s to 2 min on an unknown machine".
std::string expected_time(const Plan &plan);

std::string processor_name(); ///< of /proc/cpuinfo

} // namespace rimpact::planning

/// How long a list of finite-element runs takes: from the plans' estimates, corrected by what finished runs took.
#pragma once
#include "app/jobs/main_jobs.h"

namespace rimpact::app {

/// One run of a list, in the order in which they are started; out: kept from before or failed, which tells nothing of
/// times.
struct RunTime {
  enum class State { waiting, running, finished, out } state = State::waiting;
  double expected = 0; ///< [s], of its plan
  double spent = 0;    ///< [s]: so far, or in all when finished
};

/// Of each job, by its plan: [s].
std::vector<RunTime> expected_times(const std::vector<Job> &jobs);

/// Seconds until the last run ends, `at_once` side by side. Expectations are scaled by what the finished runs took over
/// what was expected of them; a run that outlasts its expectation has a tenth of it left.
double time_to_go(const std::vector<RunTime> &runs, std::size_t at_once);

/// "about 3 min", "about 1 h 20 min": two digits are all an estimate has.
std::string about(double seconds);

} // namespace rimpact::app

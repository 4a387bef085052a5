/// What a calibration reports of each run, and whether a set of runs may be fitted together.
#pragma once
#include "calibration/answer/calibration.h"

namespace rimpact::calibration {

/// Throws InputError when a run is named twice.
void require_distinct(const std::vector<std::string> &folders);
/// Throws InputError when two runs hold the same response.
void require_distinct(const std::vector<StoredRun> &runs);
/// Throws InputError naming both folders and what differs: bearing, load or settings of the reduced model.
void require_same_device(const std::vector<StoredRun> &runs);

/// The run against the reduced model with the fitted values; `fitted`: the run took part in the fit.
RunCheck check_run(const StoredRun &run, const FitResult &result, const FitOptions &options, bool fitted);

} // namespace rimpact::calibration

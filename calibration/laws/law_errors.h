/// How far one fitted law is from the runs, fitted and left out.
#pragma once
#include "calibration/laws/law_ranking.h"

namespace rimpact::calibration {

/// Whether it has impacts and all of them graze the rim, or it has none.
bool only_grazing(const StoredRun &run);

/// Throws what the reduced model throws for values it refuses.
LawError error_of(const StoredRun &run, const FitResult &result);

/// Each run, and each Ricker pulse with all its scales, left out in turn: fitted to the others from `all`'s
/// values, asked for what is left out. Sets that leave nothing but grazing impacts are passed over.
std::vector<LeftOut> leave_out(const std::vector<const StoredRun *> &runs, const FitOptions &options,
                               const FitResult &all);

} // namespace rimpact::calibration

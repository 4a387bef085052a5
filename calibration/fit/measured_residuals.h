/// Residuals of a measured impact.
#pragma once
#include "calibration/fit/residuals.h"

namespace rimpact::calibration {

/// The same of a measured impact (window.measurement is set).
std::unique_ptr<ResidualBlock> measured_block(const StoredRun &run, const ImpactWindow &window,
                                              const FitOptions &options);

} // namespace rimpact::calibration

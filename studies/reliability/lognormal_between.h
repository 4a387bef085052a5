/// Lognormal fragilities through probabilities that are known at levels of intensity.
#pragma once
#include "studies/reliability/failure_rate.h"
#include <optional>

namespace rimpact::reliability {

/// Deviation of ln intensity of a fragility below the first level: that none falls more slowly is an assumption.
inline constexpr double slowest_fall = 1;

/// The lognormal through two points of growing intensity; constant beyond them.
Fragility lognormal_between(double low, double p_low, double high, double p_high);

/// Rate from intensities below `first` [1/year] of a lognormal fragility of probability p there. None: it has no bound
/// that can be told, as the hazard grows faster than the fragility falls.
std::optional<double> rate_below_first(const HazardCurve &hazard, double first, double p, double deviation);

} // namespace rimpact::reliability

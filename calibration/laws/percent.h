/// Shares in words.
#pragma once
#include <string>

namespace rimpact::calibration {

/// A bound as it was measured, rounded up, so that what is said holds: 0.0312 is "3.2 %", 0.136 is "14 %". share >= 0.
std::string percent_up(double share);

} // namespace rimpact::calibration

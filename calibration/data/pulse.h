/// The peak of a sampled force.
#pragma once
#include <vector>

namespace rimpact::calibration {

/// Peak of a sampled pulse: a quartic through the samples above 0.8 of the largest, so that noise and the
/// sampling's phase do not enter; the largest sample when there are too few.
double smooth_peak(const std::vector<double> &times, const std::vector<double> &force);

} // namespace rimpact::calibration

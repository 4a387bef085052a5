/// Whether a record is ground motion: what is odd about its numbers.
#pragma once
#include "io/records/sampled_signal.h"
#include <string>
#include <vector>

namespace rimpact {

/// What a record leaves at its end, by exact integration from rest.
struct BaselineDrift {
  double end_velocity, end_travel;   ///< [m/s], [m]
  double peak_velocity, peak_travel; ///< [m/s], [m], >= 0
};
BaselineDrift baseline_drift(const SampledSignal &record);

/// Sentences with their figures; none of it is refused, `gravity` [m/s^2]:
///   an end velocity beyond a tenth of the peak and 0.03 m/s (fling moves the ground, but leaves it at rest), else a
///   travel beyond 10 m;
///   values of one sign: a spectrum in the record's place;
///   a mean rate, of the root mean squares, below 6 rad/s, where that of a derivative is above 8: a velocity or a
///   displacement in its place (307 accelerations of PEER have 8 to 107);
///   three values and more at the peak: saturation;
///   a peak beyond 2 g or below 0.003 g: a wrong unit, or a scale applied twice.
std::vector<std::string> record_doubts(const SampledSignal &record, double gravity);

/// The record without its baseline's drift: the least-squares parabola of the velocity, 0 at the start, is taken off it
/// by its derivative. Permanent travel of the ground does not survive it (Boore, BSSA 91, 2001).
SampledSignal baseline_corrected(const SampledSignal &record);

} // namespace rimpact

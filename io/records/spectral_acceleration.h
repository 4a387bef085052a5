/// The response spectrum of a record.
#pragma once
#include "io/records/sampled_signal.h"
#include <vector>

namespace rimpact {

/// Pseudo-acceleration S_a = w^2 max|u| [m/s^2] of a linear oscillator, w = 2 pi / period, from rest under
/// the record as ground acceleration [m/s^2], its free vibration afterwards included. Exact for the piecewise
/// linear record (Nigam and Jennings, BSSA 59, 1969); the peak is taken at samples, of the record or, where
/// they are wider than a hundredth of the period, between them. period > 0 [s], 0 <= damping < 1.
double spectral_acceleration(const SampledSignal &record, double period, double damping = 0.05);

/// The same oscillator's travel [m] at those instants, one period of its free vibration included.
std::vector<double> oscillator_travel(const SampledSignal &record, double period, double damping = 0.05);

} // namespace rimpact

/// The spectral acceleration of two horizontal components in every direction.
#pragma once
#include "io/records/sampled_signal.h"
#include <utility>

namespace rimpact {

/// RotD50 and RotD100 (Boore, BSSA 100, 2010): median and largest over all directions of the pseudo-acceleration of
/// the components' rotation [m/s^2].
struct RotatedAcceleration {
  double rotd50, rotd100;
};

/// Both from their first samples on at the shorter of their steps, straight in between; the shorter one is followed by
/// rest.
std::pair<SampledSignal, SampledSignal> together(const SampledSignal &x, const SampledSignal &y);

/// `x` and `y` at right angles, together(). Directions from 0 to 179 degrees in steps of one; oscillator as in
/// spectral_acceleration.h.
RotatedAcceleration rotated_acceleration(const SampledSignal &x, const SampledSignal &y, double period,
                                         double damping = 0.05);

} // namespace rimpact

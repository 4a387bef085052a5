/// Whether a pair of components holds a strong velocity pulse, and its period.
#pragma once
#include "io/records/sampled_signal.h"
#include <optional>

namespace rimpact {

/// By Shahi and Baker (BSSA 104, 2014): the five largest wavelets of Daubechies' fourth order over both components and
/// all periods from 0.25 to 15 s, each in its own direction. A pulse is ten wavelets of its period there, about samples
/// of the record; places and heights follow from every sample, as in the authors' program. It is classified by what it
/// leaves of peak velocity and energy, and by whether it comes early.
struct ClassifiedPulse {
  double indicator = 0;         ///< > 0: a pulse, unless it comes late; of the first that is one, else of the largest
  std::optional<double> period; ///< T_p [s]; none: no pulse
  double direction_deg = 0;     ///< of the pulse, from the first component towards the second
};

/// `first` and `second` [m/s^2] at right angles, of one sampling interval, until the shorter one ends. None: their
/// intervals differ, or nothing moves.
std::optional<ClassifiedPulse> velocity_pulse(const SampledSignal &first, const SampledSignal &second);

} // namespace rimpact

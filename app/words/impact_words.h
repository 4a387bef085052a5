/// An impact as the terminal tells it.
#pragma once
#include "responses/summary.h"
#include <string>

namespace rimpact::app {

/// A speed in the unit in which it has digits: mm/s below 1 mm/s.
std::string speed_in_words(double speed, int decimals);

/// When it came and how fast. Along a path that is pushed without inertia (`is_dynamic` false) time is a load parameter
/// and a speed has no meaning: neither is said.
std::string when(const Impact &impact, bool is_dynamic);
std::string how_fast(const Impact &impact, bool is_dynamic, int decimals);

} // namespace rimpact::app

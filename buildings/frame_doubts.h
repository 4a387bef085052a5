/// What in a frame's description looks like a wrong unit.
#pragma once
#include "buildings/frame.h"

namespace rimpact::buildings {

/// Sentences that name section or level, value and what is usual: moduli, depths of sections by sqrt(12 I / A), heights
/// of storeys, masses of slabs over their plan, damping.
std::vector<std::string> doubts_of(const Frame &frame);

} // namespace rimpact::buildings

/// What in a frame's description looks like a wrong unit.
#pragma once
#include "buildings/frame.h"

namespace rimpact::buildings {

/// Sentences that name section, level or member, value and what is usual; of several alike the first, and how many
/// more. Ratios tell units apart that values do not: G over E, shear areas over area, yield strains, masses of nodes
/// over those of slabs.
std::vector<std::string> doubts_of(const Frame &frame);

} // namespace rimpact::buildings

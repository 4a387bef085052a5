/// Reads [latin_hypercube] of a sweep: the keys that are sampled, their distributions and how they are correlated.
#pragma once
#include "studies/fleets/sweep_reader.h"

namespace rimpact::fleets {

/// Fills `samples`, `seed`, `sampled` and `correlation` of the parts. Throws as read_parts.
void read_latin_hypercube(const TomlFile &file, const std::string &origin, SweepParts &parts);

} // namespace rimpact::fleets

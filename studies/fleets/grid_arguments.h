/// A grid from the words of a command line.
#pragma once
#include "studies/fleets/sweep.h"

namespace rimpact::fleets {

/// A grid from arguments KEY=a:b:n, n >= 1 values evenly from a to b (n = 1: a = b). Throws InputError
/// "--sweep KEY=a:b:n: ..." for the same reasons.
Sweep grid_of_arguments(const std::vector<std::string> &arguments);

} // namespace rimpact::fleets

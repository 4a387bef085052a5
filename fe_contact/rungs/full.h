/// Rung full: the stack of rung rigid-dish on the whole plate, whose deformed dish carries the exact surface.
#pragma once
#include "fe_contact/rungs/rung.h"

namespace rimpact::fe::rungs {

extern const Rung full;

} // namespace rimpact::fe::rungs

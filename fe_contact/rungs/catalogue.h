/// The rungs there are, a line each.
#pragma once
#include "fe_contact/rungs/rung.h"
#include <string>

namespace rimpact::fe {

namespace rungs {
extern const Rung rim, rigid_dish, full;
}

/// By the name a scene has. Throws InputError.
const Rung &rung_of(const std::string &name);

} // namespace rimpact::fe

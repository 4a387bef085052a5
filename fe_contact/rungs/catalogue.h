/// The rungs there are, a line each.
#pragma once
#include "fe_contact/rungs/rung.h"

namespace rimpact::fe {

/// Throws InputError for a rung that this build has not.
const Rung &rung_of(scene::Rung name);

} // namespace rimpact::fe

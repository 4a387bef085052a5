/// Where a search begins: an element's numbers read off the curves of impacts, before anything is fitted.
#pragma once
#include "calibration/data/impact_window.h"
#include "calibration/fit/parameter.h"

namespace rimpact::calibration {

/// `scene` with k_i, e and what its law reads of a yielding rim as the impacts say: e and k_i by the hardest impact
/// read as spring and dashpot; of a law that yields k_i by the gentlest, and then those of the numbers that are `free`
/// by the hardest impact's force over its penetration (path_fit.h).
scene::Scene first_guess(scene::Scene scene, const std::vector<const ImpactWindow *> &windows,
                         const std::vector<const Parameter *> &free);

} // namespace rimpact::calibration

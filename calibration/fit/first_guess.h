/// Where a search begins: an element's numbers read off the curves of impacts, before anything is fitted.
#pragma once
#include "calibration/data/impact_window.h"
#include <optional>

namespace rimpact::calibration {

/// Force over penetration of one impact as straight lines, by least squares: slopes in N/m, penetrations in m.
struct CurveReading {
  double initial;   ///< slope from 5 to 40 % of the peak on the way in, > 0
  double tangent;   ///< slope from 75 % of the peak on, on the way in
  double unloading; ///< slope from 95 to 50 % of the peak on the way back
  double peak;      ///< force [N]
  double deepest;   ///< penetration
  /// Force at which the tangent through the peak meets d = 0: F_y of a law whose tangent is a plateau's.
  double intercept() const { return peak - tangent * deepest; }
};
/// None where one of the lines has fewer than three samples, or the first does not rise.
std::optional<CurveReading> read_curve(const ImpactWindow &window);

/// `scene` with k_i, e and what its law reads of a yielding rim as the impacts say: e and k_i by the hardest impact
/// read as spring and dashpot; of a law that yields k_i by the stiffest reading, F_y, h and a by the hardest impact's
/// curve.
scene::Scene first_guess(scene::Scene scene, const std::vector<const ImpactWindow *> &windows);

} // namespace rimpact::calibration

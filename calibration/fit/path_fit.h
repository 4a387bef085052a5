/// Numbers of a law that yields, from the force over the penetrations that were measured. Nothing is integrated: the
/// law's force F(d, deepest so far) is compared at each sample, so that a fit takes milliseconds. Noise of the
/// penetration biases it; a search begins there.
#pragma once
#include "calibration/data/impact_window.h"
#include "calibration/fit/parameter.h"

namespace rimpact::calibration {

/// `scene` with `free` moved within their bounds so that sum (F(d_i, max_{j<i} d_j) - F_i)^2 of the samples in contact
/// is least, the best of several starts. Penetration d [m] counts from the window's capacity, force F in N. As it was
/// where the law does not yield or fewer samples press than there are numbers to find.
scene::Scene fit_over_path(scene::Scene scene, const ImpactWindow &window, const std::vector<const Parameter *> &free);

} // namespace rimpact::calibration

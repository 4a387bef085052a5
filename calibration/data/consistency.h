/// Whether a measured table can be what it is said to be.
#pragma once
#include "calibration/data/measured_run.h"

namespace rimpact::calibration {

/// Throws DataError when the force lasts so long that it would push the mass out of the bearing: before anything is
/// looked for in samples of a wrong clock.
void require_clock(const Response &response, const scene::Scene &scene, const std::string &table);
/// Throws DataError when the figures of a run contradict each other by more than a factor of three: velocity
/// against the displacement's slope; or the rim's force, by its impulse, against the motion it causes (two where
/// nothing else acts), surely by what is known of the approach speed. `force_unit`: as declared, to name a slip.
void require_consistent(const StoredRun &run, const std::string &force_unit = "");

} // namespace rimpact::calibration

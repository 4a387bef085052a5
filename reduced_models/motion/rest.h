/// How long a resting bearing rests.
#pragma once
#include "reduced_models/bearings/dynamics.h"

namespace rimpact::reduced {

/// Instant in (t, t_end] at which a mass at rest starts to slide (or lift), or t_end; shared with the CVODE
/// driver.
double end_of_rest(const Dynamics &dynamics, const Mode &mode, const State &y, double t, double t_end, double scan);

} // namespace rimpact::reduced

/// The quasi-static kinds (cyclic, figure-eight, path, push): forces along a prescribed path, in closed form
/// (thesis 2.2.3): N from vertical equilibrium N n_z + f_z = W, friction along the path, the rim element's
/// spring where it is pressed.
#pragma once
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"

namespace rimpact::reduced {

/// `time` of the response is the load parameter 0..1. Only the spring of the rim element acts (no rates). A path that
/// breaks the rim off (foot_limit.h) ends before it, with status `stopped`.
ReducedRun quasi_static(const scene::Scene &scene);

} // namespace rimpact::reduced

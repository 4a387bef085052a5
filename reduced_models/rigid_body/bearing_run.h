/// Whole scenes by the models of bearings of rigid bodies: DCFP, LIR-DCFP and TFP.
#pragma once
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"

namespace rimpact::reduced {

/// reduced.model "dcfp", "lir-dcfp" or "tfp". Adds to the physical model's signals `tilt` and `interface_slip_x|y`,
/// and `isolator` to the summary: extreme normal forces of the points, extreme
/// vertical force and moment on the plate (about its vertex, horizontal), residual slip; of a TFP also signals and
/// `faces` of the summary for each face. `k_i` is one rim's; all rims stop the mass in series, and `impact_x|y` is the
/// top plate's. A slider that leaves a rim or overturns gives status "stopped"
/// with the reason. Quasi-static kinds drive the plate slowly (at most `drive_speed`); only the springs of
/// rim and stop act.
ReducedRun simulate_rigid_bodies(const scene::Scene &scene);

inline constexpr double drive_speed = 2e-3; ///< [m/s]

} // namespace rimpact::reduced

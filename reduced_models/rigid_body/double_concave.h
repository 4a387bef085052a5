/// Whole scenes by the rigid-body models of the DCFP and LIR-DCFP bearings.
#pragma once
#include "reduced_models/physical_model.h"

namespace rimpact::reduced {

/// reduced.model "dcfp" or "lir-dcfp". Adds to the physical model's signals `tilt` and `interface_slip_x|y`,
/// and `isolator` to the summary: extreme normal forces of the points, extreme
/// vertical force and moment on the plate (about its vertex, horizontal), residual slip. `k_i` is one
/// rim's; the pair stops the mass in series. A slider that leaves a rim or overturns gives status "stopped"
/// with the reason. Quasi-static kinds drive the plate slowly (at most `drive_speed`); only the springs of
/// rim and stop act.
ReducedRun simulate_double_concave(const scene::Scene &scene);

inline constexpr double drive_speed = 2e-3; ///< [m/s]

} // namespace rimpact::reduced

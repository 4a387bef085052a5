/// A second method: SUNDIALS CVODE (BDF, dense Newton by differences) on the plain equations, written anew. No branches
/// and no events: Park-Wen friction, an elliptic dish in closed form, the rim by Hunt-Crossley, never pulling; every
/// slider stays on its dish (asked for: N > 0). Shares M, C, K and the sliders' places with buildings/, no more.
#pragma once
#include "buildings/assembly.h"
#include "scene/scene.h"

namespace rimpact::buildings {

struct PlainAnswer {
  Eigen::VectorXd final;                            ///< q at the end
  double travel = 0, base_shear = 0, rim_force = 0; ///< largest over the steps, of any bearing [m], [N], [N]
  double drift = 0, smallest_normal = 1e300;        ///< first storey [m]; [N]
  long n_steps = 0;
};
/// `tolerance`: relative; absolute over 0.4 m and 2 m/s. Steps up to 20 ms.
PlainAnswer plain_cvode(const BuildingModel &model, const scene::Scene &scene, double tolerance);

} // namespace rimpact::buildings

/// What the plans of several rungs are made of.
#pragma once
#include "fe_contact/planning/plan.h"
#include "responses/response.h"
#include "responses/summary.h"

namespace rimpact::planning {

/// Of a half model: unknowns, seconds a Newton iteration on two cores, memory [B]. The whole model has twice the
/// unknowns and takes about three times as long.
struct MeshCost {
  long dofs;
  double seconds_per_iteration, memory;
};
/// Newton iterations of one impact on rung rim, from how deep it presses. Measured on 12 windows and pulses of
/// shfps-225 and of a bearing of 3 m under 204 t, meshes 0 and 1, 0.005 to 1.5 m/s: 50 + 130 sqrt(depth / mm), 23 % too
/// many to 9 % too few. A stack's impact takes 90 more and 20 % fewer for its depth.
double iterations_of_impact(double depth);
/// Depth to which a mass at `speed` presses the rim [m]: a power of its energy, from the same windows (0.05 to 1 m/s,
/// within 20 %), over the rim's hardness in yield stress and thickness (within 30 %, yield 100 to 1000 MPa, 10 to 100
/// mm).
double depth_of_impact(const scene::Scene &scene, double speed);
void add_impacts(Plan &plan, const Summary &scout, const Response &response);
void add_pad_note(Plan &plan, const scene::Scene &scene);

} // namespace rimpact::planning

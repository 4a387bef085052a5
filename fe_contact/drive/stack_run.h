/// Rung rigid-dish: the deformable stack on the exact dish. Quasi-static paths (stack_static.cc), and motion in time
/// with impacts on the rim (stack_dynamic.cc).
#pragma once
#include "fe_contact/drive/run_record.h"

namespace rimpact::fe {

/// Away from the rim, sliding [s].
constexpr double longest_sliding_step = 0.01;
/// A slower slider rests, if the scout has done sliding too; the stack rings with half of it [m/s].
constexpr double sliding_speed = 1e-2;

/// Runs a cyclic or figure-eight scene into `record`. Throws SolverStopped or Interrupted with the record as it
/// stands.
void run_stack_static(const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options,
                      RunRecord &record);

/// Likewise a window, a pulse or a record.
void run_stack_dynamic(const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options,
                       RunRecord &record);

} // namespace rimpact::fe

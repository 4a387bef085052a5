/// Rung R2: the deformable stack on the exact dish. Quasi-static paths (stack_static.cc), and motion in time with
/// impacts on the rim (stack_dynamic.cc).
#pragma once
#include "fe_contact/runner/run_record.h"

namespace rimpact::fe {

/// Runs a cyclic or figure-eight scene into `record`. Throws SolverStopped or Interrupted with the record as it
/// stands.
void run_stack_static(const scene::Scene &scene, const Plan &plan, const RunOptions &options, RunRecord &record);

/// Likewise a window, a pulse or a record.
void run_stack_dynamic(const scene::Scene &scene, const Plan &plan, const RunOptions &options, RunRecord &record);

} // namespace rimpact::fe

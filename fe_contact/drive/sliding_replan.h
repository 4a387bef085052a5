/// A run on the dish that is planned again where its slider comes to the rim and none is meshed.
#pragma once
#include "fe_contact/drive/sliding_run.h"

namespace rimpact::fe {

/// Runs a window, a pulse or a record into `record`. Throws SolverStopped or Interrupted with the record as it stands.
void run_sliding(const Rung &rung, const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options,
                 RunRecord &record);

} // namespace rimpact::fe

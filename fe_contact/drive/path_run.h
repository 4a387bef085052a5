/// Quasi-static paths of any rung: preload under the dead load where there is a dish, then the top face is driven along
/// the path.
#pragma once
#include "fe_contact/drive/run_record.h"
#include "fe_contact/rungs/rung.h"

namespace rimpact::fe {

/// Runs a push, a cyclic or a figure-eight scene into `record`. Throws SolverStopped or Interrupted with the record as
/// it stands.
void run_path(const Rung &rung, const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options,
              RunRecord &record);

} // namespace rimpact::fe

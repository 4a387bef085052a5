/// Rung rim: whole histories and windows (rim_run.cc), quasi-static pushes (rim_push.cc). Between impacts the
/// reduced model flies; while the walls touch, the solids are stepped implicitly with the rest of the bearing
/// acting on the slider's top face. Each touched arc keeps its own yielded state.
#pragma once
#include "fe_contact/drive/checkpoint.h"
#include "fe_contact/drive/run_record.h"
#include "fe_contact/rungs/mass_loads.h"
#include "fe_contact/rungs/rim.h"

namespace rimpact::fe {

/// One touched arc of the rim.
struct Arc {
  RimFrame frame;
  SystemState state;
  bool yielded = false;
};

/// Mesh options of the plan, and tolerances of the scene's steps.
meshes::RimMeshOptions rim_mesh_options(const scene::Scene &scene, const planning::Plan &plan);
StepOptions rim_step_options(const scene::Scene &scene);

/// Runs into `record`. Throw SolverStopped or Interrupted with the record as it stands.
void run_rim_dynamic(const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options,
                     RimSystem &system, RunRecord &record);
void run_rim_push(const scene::Scene &scene, const RunOptions &options, RimSystem &system, RunRecord &record);

} // namespace rimpact::fe

#include "buildings/simulate.h"
#include "buildings/building_run.h"
#include "files/error.h"
#include <chrono>

namespace rimpact::buildings {

reduced::ReducedRun simulate(const Frame &frame, const scene::Scene &scene, const std::vector<scene::Bearing> &bearings,
                             bool with_response) {
  const auto begin = std::chrono::steady_clock::now();
  reduced::ReducedRun run;
  const BuildingModel model = assemble(frame);
  const BuildingDynamics dynamics(model, scene, bearings);
  BuildingRecorder recorder(dynamics, with_response ? &run.response : nullptr, scene.reduced.output_step);
  try {
    run.summary.n_steps = BuildingRun(dynamics, scene).run(scene.excitation.duration, recorder);
  } catch (const SolverStopped &stop) {
    run.summary.status = "stopped", run.summary.reason = stop.what();
  }
  recorder.summarise(run.summary);
  run.summary.n_dofs = model.n_dofs();
  run.summary.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  run.summary.time_split["solve"] = run.summary.wall_time;
  return run;
}

} // namespace rimpact::buildings

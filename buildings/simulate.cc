#include "buildings/simulate.h"
#include "buildings/building_run.h"
#include "files/error.h"
#include <chrono>

namespace rimpact::buildings {
namespace {

/// The run of a recorder; its summary's times since `begin`.
void fly(const BuildingDynamics &dynamics, const scene::Scene &scene, BuildingRecorder &recorder, Summary &summary) {
  const auto begin = std::chrono::steady_clock::now();
  try {
    summary.n_steps = BuildingRun(dynamics, scene).run(scene.excitation.duration, recorder);
  } catch (const SolverStopped &stop) {
    summary.status = "stopped", summary.reason = stop.what();
  }
  recorder.summarise(summary);
  summary.n_dofs = dynamics.n;
  summary.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  summary.time_split["solve"] = summary.wall_time;
}

} // namespace

BuildingResult simulate_whole(const Frame &frame, const scene::Scene &scene,
                              const std::vector<scene::Bearing> &bearings, double picture_step) {
  BuildingResult result;
  result.model = assemble(frame), result.trace.step = picture_step;
  const MemberForces members(frame, result.model);
  const BuildingDynamics dynamics(result.model, scene, bearings);
  BuildingRecorder recorder(dynamics, &result.run.response, scene.reduced.output_step, &result.trace, &members);
  fly(dynamics, scene, recorder, result.run.summary);
  return result;
}

reduced::ReducedRun simulate(const Frame &frame, const scene::Scene &scene, const std::vector<scene::Bearing> &bearings,
                             bool with_response) {
  reduced::ReducedRun run;
  const BuildingModel model = assemble(frame);
  const BuildingDynamics dynamics(model, scene, bearings);
  BuildingRecorder recorder(dynamics, with_response ? &run.response : nullptr, scene.reduced.output_step);
  fly(dynamics, scene, recorder, run.summary);
  return run;
}

} // namespace rimpact::buildings

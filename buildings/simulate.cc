#include "buildings/simulate.h"
#include "buildings/building_run.h"
#include "buildings/implicit_run.h"
#include "files/error.h"
#include <algorithm>
#include <chrono>

namespace rimpact::buildings {
namespace {

struct Kept {
  Response *response;
  BuildingTrace *trace = nullptr;
  const MemberForces *members = nullptr;
};

/// What `go` does with a recorder; its summary's times.
template <class Go>
void fly(const BuildingBasis &building, const scene::Scene &scene, const Kept &kept, Summary &summary, Go go) {
  BuildingRecorder recorder(building, kept.response, scene.reduced.output_step, kept.trace, kept.members);
  const auto begin = std::chrono::steady_clock::now();
  try {
    summary.n_steps = go(recorder);
  } catch (const SolverStopped &stop) {
    summary.status = RunStatus::stopped, summary.reason = stop.what();
  }
  recorder.summarise(summary);
  summary.n_dofs = building.n;
  summary.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  summary.time_split["solve"] = summary.wall_time;
}

void fly(const BuildingModel &model, const scene::Scene &scene, const std::vector<scene::Scene> &bearings,
         const Kept &kept, Summary &summary) {
  const double t_end = scene.excitation.duration;
  const auto concave = [](const auto &one) { return one.double_concave(); };
  if (!concave(scene) && std::none_of(bearings.begin(), bearings.end(), concave)) {
    const BuildingDynamics dynamics(model, scene, bearings);
    return fly(dynamics, scene, kept, summary,
               [&](BuildingRecorder &recorder) { return BuildingRun(dynamics, scene).run(t_end, recorder); });
  }
  const std::vector<scene::Scene> alike(model.bearings.size(), scene);
  MountedBuilding building(model, scene, bearings.empty() ? alike : bearings);
  ImplicitRun run(building, scene);
  fly(building, scene, kept, summary, [&](BuildingRecorder &recorder) { return run.run(t_end, recorder); });
  summary.n_newton_iterations = run.n_newton;
}

} // namespace

BuildingResult simulate_whole(const Frame &frame, const scene::Scene &scene, const std::vector<scene::Scene> &bearings,
                              double picture_step) {
  BuildingResult result;
  result.model = assemble(frame), result.trace.step = picture_step;
  const MemberForces members(frame, result.model);
  fly(result.model, scene, bearings, {&result.run.response, &result.trace, &members}, result.run.summary);
  return result;
}

reduced::ReducedRun simulate(const Frame &frame, const scene::Scene &scene, const std::vector<scene::Scene> &bearings,
                             bool with_response) {
  reduced::ReducedRun run;
  fly(assemble(frame), scene, bearings, {with_response ? &run.response : nullptr}, run.summary);
  return run;
}

} // namespace rimpact::buildings

#include "buildings/simulate.h"
#include "buildings/building_run.h"
#include "buildings/implicit_run.h"
#include "buildings/inelastic_frame.h"
#include "buildings/linear_structure.h"
#include "io/files/error.h"
#include "reduced_models/simulate.h"
#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::buildings {
namespace {

struct Kept {
  Response *response;
  BuildingTrace *trace = nullptr;
  const MemberForces *members = nullptr;
};

/// What an inelastic frame in the plane of x and z cannot have.
void check_plane(const Frame &frame, const scene::Scene &scene) {
  const auto &e = scene.excitation;
  const auto refuse = [](const std::string &what) {
    throw InputError(what + ": an inelastic frame moves in the plane of x and z");
  };
  if (e.kind == scene::ExcitationKind::ricker && std::abs(e.direction().y()) > 1e-12)
    refuse(fmt::format("excitation.direction_deg {:g} is neither 0 nor 180", e.direction_deg));
  if (e.kind == scene::ExcitationKind::record && !e.y.values.empty()) refuse("excitation.y is given");
  if (e.kind == scene::ExcitationKind::free && (e.start_displacement().y() != 0 || e.start_velocity().y() != 0))
    refuse("excitation: the start has a part along y");
  if (static_cast<int>(frame.elements.size()) > most_members)
    throw InputError(
        fmt::format("the inelastic frame has {} members; {} are the most", frame.elements.size(), most_members));
}

/// Bearings that differ have dishes that differ.
void check_start(const BuildingBasis &building, const scene::Excitation &e) {
  if (e.kind != scene::ExcitationKind::free) return;
  const double start = e.start_displacement().norm();
  for (std::size_t b = 0; b < building.capacity.size(); ++b)
    if (!(start <= building.capacity[b]))
      throw InputError(
          fmt::format("excitation.displacement_m starts at {:.6g} m, beyond the rim of bearing {} at L_c = {:.6g} m",
                      start, b + 1, building.capacity[b]));
}

/// What dishes stand on where steps are implicit: a stiffness that no drawing gives, unless the user did.
nlohmann::json dish_springs(const scene::Isolator &isolator) {
  return {{"stiffness_N_per_m", isolator.points * isolator.contact_stiffness},
          {"restitution", isolator.contact_restitution},
          {"assumed", isolator.contact_stiffness == scene::Isolator().contact_stiffness}};
}

/// What `go` does with a recorder; its summary's times.
template <class Go>
HingeEnvelope fly(const BuildingBasis &building, const scene::Scene &scene, const Kept &kept, Summary &summary, Go go) {
  BuildingRecorder recorder(building, kept.response, scene.reduced.output_step, kept.trace, kept.members);
  const auto begin = std::chrono::steady_clock::now();
  try {
    go(recorder);
  } catch (const SolverStopped &stop) {
    summary.status = RunStatus::stopped, summary.reason = stop.what();
  }
  recorder.summarise(summary);
  summary.n_dofs = building.n;
  summary.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  summary.time_split["solve"] = summary.wall_time;
  return recorder.hinges();
}

void fly(const Frame &frame, const BuildingModel &model, const scene::Scene &scene,
         const std::vector<scene::Scene> &bearings, const Kept &kept, Summary &summary) {
  const double t_end = scene.excitation.duration;
  const auto any = [&](auto has) { return has(scene) || std::any_of(bearings.begin(), bearings.end(), has); };
  const bool rigid_bodies = any([](const scene::Scene &one) { return one.rigid_bodies(); });
  const bool coulomb = any([](const scene::Scene &one) { return one.reduced.friction == scene::Friction::coulomb; });
  if (frame.inelastic()) check_plane(frame, scene);
  const bool measured = any([](const scene::Scene &one) { return one.reduced.measured.any(); });
  if (!frame.inelastic() && !rigid_bodies && !coulomb && !measured) {
    const BuildingDynamics dynamics(model, scene, bearings);
    check_start(dynamics, scene.excitation);
    fly(dynamics, scene, kept, summary,
        [&](BuildingRecorder &recorder) { return BuildingRun(dynamics, scene).run(t_end, recorder); });
    return;
  }
  const std::vector<scene::Scene> alike(model.bearings.size(), scene);
  MountedBuilding building(model, scene, bearings.empty() ? alike : bearings,
                           frame.inelastic() ? inelastic_structure(frame, model, scene.load.gravity)
                                             : linear_structure(model, scene.load.gravity));
  check_start(building, scene.excitation);
  ImplicitRun run(building, scene);
  const auto hinges =
      fly(building, scene, kept, summary, [&](BuildingRecorder &recorder) { return run.run(t_end, recorder); });
  summary.n_newton_iterations = run.n_newton;
  const auto dish = [](const scene::Scene &one) { return !one.rigid_bodies(); };
  if (bearings.empty() ? dish(scene) : std::any_of(bearings.begin(), bearings.end(), dish))
    summary.extra["building"]["dish_springs"] = dish_springs(scene.isolator);
  if (!frame.inelastic()) return;
  summary.extra["building"]["inelastic"] = to_json(frame, hinges);
  if (kept.trace) kept.trace->hinges = hinges;
}

} // namespace

BuildingResult simulate_whole(const Frame &frame, const scene::Scene &scene, const std::vector<scene::Scene> &bearings,
                              double picture_step) {
  BuildingResult result;
  result.model = assemble(frame), result.trace.step = picture_step;
  const MemberForces members(frame, result.model);
  fly(frame, result.model, scene, bearings, {&result.run.response, &result.trace, &members}, result.run.summary);
  return result;
}

reduced::ReducedRun simulate(const Frame &frame, const scene::Scene &scene, const std::vector<scene::Scene> &bearings,
                             bool with_response) {
  reduced::ReducedRun run;
  fly(frame, assemble(frame), scene, bearings, {with_response ? &run.response : nullptr}, run.summary);
  return run;
}

} // namespace rimpact::buildings

// Whole scenes by the physical model: the entry points of physical_model.h.
#include "reduced_models/simulate.h"

#include "io/files/error.h"
#include "reduced_models/catalogue.h"
#include "reduced_models/motion/cvode_run.h"
#include "reduced_models/motion/hybrid_run.h"
#include "reduced_models/motion/integrator_check.h"
#include "reduced_models/motion/quasi_static.h"
#include "reduced_models/rigid_body/bearing_run.h"
#include <algorithm>
#include <chrono>
#include <cmath>

namespace rimpact::reduced {

namespace {

struct Job {
  const scene::Scene &scene;
  BearingState start;
  double t_end;
  double capacity = -1; ///< < 0: the bearing's own
  bool by_cvode = false;
};

/// `response` may be null. A slider that leaves the dish ends the run with status `stopped`.
void run(const Job &job, Response *response, Summary &summary) {
  const auto begin = std::chrono::steady_clock::now();
  const Dynamics dynamics(job.scene, true, job.capacity);
  EnergyLedger before;
  State y;
  const Mode mode = dynamics.starting_mode(job.start, y);
  before.initial = dynamics.kinetic_energy(y);
  if (job.scene.excitation.kind == scene::ExcitationKind::free) { // let go from a height: part of what it starts with
    before.gravity = dynamics.potential_energy(y);
    before.initial += before.gravity;
  }
  Recorder recorder(dynamics, response, job.scene.reduced.output_step, before);
  bool collapsed = false;
  try {
    collapsed = job.by_cvode ? run_with_cvode(dynamics, job.scene, job.start, job.t_end, recorder)
                             : HybridRun(dynamics, job.scene).run(job.start, job.t_end, {}, recorder).collapsed;
  } catch (const SolverStopped &stop) {
    summary.status = RunStatus::stopped, summary.reason = stop.what();
  }
  recorder.summarise(summary, collapsed);
  summary.rung = SolvedBy::reduced;
  summary.n_dofs = 3 * (1 + dynamics.building.n_floors());
  summary.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  summary.time_split["solve"] = summary.wall_time;
}

/// CVODE's run, beside the own steps'.
ReducedRun checked_by_cvode(scene::Scene scene) {
  ReducedRun result = simulate_with_cvode(scene);
  scene.reduced.integrator = scene::Integrator::own;
  result.summary.extra["integrator"] = integrator_check(result.summary, simulate_summary(scene));
  return result;
}

ReducedRun simulate_physical(const scene::Scene &scene) {
  if (scene.reduced.integrator == scene::Integrator::cvode) return checked_by_cvode(scene);
  if (!scene.excitation.is_dynamic()) return quasi_static(scene);
  ReducedRun result;
  run({scene, PhysicalModel(scene).initial_state(), scene.excitation.duration}, &result.response, result.summary);
  return result;
}

} // namespace

const std::vector<ReducedModel> &reduced_models() {
  static const std::vector<ReducedModel> models = {
      {scene::ModelKind::physical,
       "a mass on the dish with Coulomb or Park-Wen friction, uplift and a rim element (thesis 2.2)",
       simulate_physical},
      {scene::ModelKind::dcfp,
       "double concave bearing: slider and top plate as rigid bodies on contact points (thesis 3.3)",
       simulate_rigid_bodies},
      {scene::ModelKind::lir_dcfp,
       "double concave bearing whose slider has a high-friction interface with a gap (thesis 3.3)",
       simulate_rigid_bodies},
      {scene::ModelKind::tfp,
       "triple friction pendulum: two slide plates, an inner slider and a rim at each of four faces",
       simulate_rigid_bodies},
  };
  return models;
}

const ReducedModel &reduced_model(scene::ModelKind kind) {
  const auto &models = reduced_models();
  return *std::find_if(models.begin(), models.end(), [&](const auto &model) { return model.kind == kind; });
}

ReducedRun simulate(const scene::Scene &scene) {
  if (scene.reduced.integrator == scene::Integrator::cvode && scene.rigid_bodies())
    throw InputError("reduced.integrator \"cvode\" moves a mass on one dish: reduced.model \"" +
                     word(scene.reduced.model) + "\" has rigid bodies on contact points, which take implicit steps");
  return reduced_model(scene.reduced.model).simulate(scene);
}

ReducedRun simulate_with_cvode(const scene::Scene &scene) {
  if (!scene.excitation.is_dynamic())
    throw InputError("excitation.kind \"" + word(scene.excitation.kind) +
                     "\" is quasi-static: there is nothing for CVODE to integrate");
  ReducedRun result;
  run({.scene = scene,
       .start = PhysicalModel(scene).initial_state(),
       .t_end = scene.excitation.duration,
       .by_cvode = true},
      &result.response, result.summary);
  return result;
}

Summary simulate_summary(const scene::Scene &scene) {
  const auto &r = scene.reduced;
  if (r.model != scene::ModelKind::physical || r.integrator == scene::Integrator::cvode ||
      !scene.excitation.is_dynamic())
    return simulate(scene).summary;
  Summary summary;
  run({scene, PhysicalModel(scene).initial_state(), scene.excitation.duration}, nullptr, summary);
  return summary;
}

ReducedRun simulate_from(const scene::Scene &scene, const BearingState &start, double t_end, double capacity) {
  if (!scene.excitation.is_dynamic())
    throw InputError("excitation.kind \"" + word(scene.excitation.kind) +
                     "\" is quasi-static: there is no state to start from");
  ReducedRun result;
  run({scene, start, t_end, capacity}, &result.response, result.summary);
  return result;
}

std::optional<double> critical_scale(scene::Scene scene, double low, double high, double relative) {
  const auto touches = [&](double scale) {
    scene.excitation.scale = scale;
    const Dynamics dynamics(scene, false);
    Recorder recorder(dynamics, nullptr, scene.reduced.output_step);
    HybridRun stepper(dynamics, scene);
    const double capacity = dynamics.lateral_capacity;
    return stepper
        .run(
            PhysicalModel(scene).initial_state(), scene.excitation.duration,
            [&](const Eigen::Vector3d &u) { return capacity - std::hypot(u[0], u[1]); }, recorder)
        .stopped;
  };
  if (touches(low) || !touches(high)) return std::nullopt;
  while (high - low > relative * high) {
    const double middle = (low + high) / 2;
    (touches(middle) ? high : low) = middle;
  }
  return high;
}

} // namespace rimpact::reduced

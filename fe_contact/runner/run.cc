// Runs a scene by finite elements and writes its folder, whatever happens on the way.
#include "fe_contact/runner/run.h"

#include "fe_contact/runner/rim_run.h"
#include "scene/error.h"
#include <chrono>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::fe {
namespace {

scene::Summary summarise(const scene::Scene &scene, const RunRecord &record, const RimSolver *solver,
                         double seconds) {
  scene::Summary summary;
  if (record.response.size() > 0) scene::summarise_response(record.response, summary);
  summary.impacts = record.impacts; // exact instants and speeds, not those of the samples
  summary.energy = record.ledger;
  summary.rung = "rim";
  summary.mesh = scene.model.mesh;
  summary.n_steps = record.n_steps;
  summary.n_newton_iterations = record.n_newton;
  summary.min_normal_force = record.smallest_normal;
  summary.wall_time = seconds;
  summary.peak_memory_bytes = scene::peak_memory_bytes();
  double output = seconds;
  if (solver) {
    summary.n_dofs = solver->n_equations();
    summary.time_split = solver->time_split;
    for (const auto &[name, value] : solver->time_split) output -= value;
    const auto &r = record.response;
    if (r.has("plastic_strain_max") && r.size() > 0)
      summary.max_plastic_strain = r.series("plastic_strain_max").back();
  }
  summary.time_split["output"] = std::max(0.0, output); // meshing, flights and files
  summary.extra["cuts"] = record.n_cuts;
  summary.extra["augmentation_cap_reached"] = record.augmentation_caps;
  summary.extra["warnings"] = record.warnings;
  return summary;
}

} // namespace

void check_supported(const scene::Scene &scene) {
  using Kind = scene::ExcitationKind;
  if (scene.model.rung != "rim")
    throw InputError("model.rung '" + scene.model.rung +
                     "' is not in this build; it has: rim (and reduced, by `rimpact reduced`)");
  if (scene.excitation.kind == Kind::cyclic || scene.excitation.kind == Kind::figure_eight)
    throw InputError("excitation.kind '" + scene::to_string(scene.excitation.kind) +
                     "' moves on the dish without touching the rim; rung `rim` has nothing to solve there");
  if (scene.bearing.contact.rim != 0)
    throw InputError("contact.rim " + std::to_string(scene.bearing.contact.rim) +
                     " is not 0: rung `rim` has frictionless walls");
}

scene::Summary run(const scene::Scene &scene, const Plan &plan, const RunOptions &options) {
  check_supported(scene);
  const auto start = std::chrono::steady_clock::now();
  RunRecord record;
  std::unique_ptr<RimSolver> solver;
  std::exception_ptr failure;
  std::string status = "done", reason;
  std::filesystem::create_directories(options.folder);
  try {
    solver =
        std::make_unique<RimSolver>(scene.bearing, rim_mesh_options(scene, plan), rim_solver_options(scene));
    if (scene.excitation.kind == scene::ExcitationKind::push)
      run_rim_push(scene, options, *solver, record);
    else
      run_rim_dynamic(scene, plan, options, *solver, record);
  } catch (const Interrupted &error) {
    status = "interrupted";
    reason = error.what();
    failure = std::current_exception();
  } catch (const SolverStopped &error) {
    status = "stopped";
    reason = error.what();
    failure = std::current_exception();
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  scene::Summary summary = summarise(scene, record, solver.get(), seconds);
  summary.status = status;
  summary.reason = reason;
  summary.extra["plan"] = to_json(plan);
  scene::write_run_folder(options.folder, scene, record.response, summary);
  write_pvd(options, record);
  if (failure) std::rethrow_exception(failure);
  return summary;
}

} // namespace rimpact::fe

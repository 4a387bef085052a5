// Runs a scene by finite elements and writes its folder, whatever happens on the way.
#include "fe_contact/drive/run.h"

#include "fe_contact/drive/fields.h"
#include "fe_contact/drive/flight_run.h"
#include "fe_contact/drive/memory_limit.h"
#include "fe_contact/drive/order.h"
#include "fe_contact/drive/path_run.h"
#include "fe_contact/drive/record_checkpoint.h"
#include "fe_contact/drive/sliding_replan.h"
#include "fe_contact/drive/solver_counts.h"
#include "fe_contact/planning/refusal.h"
#include "fe_contact/solver/ranks.h"
#include "io/files/error.h"
#include "responses/identity.h"
#include "responses/limits.h"
#include "responses/open_impact.h"
#include "responses/run_folder.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <new>
#include <optional>
#include <system_error>

namespace rimpact::fe {
namespace {

/// Of a slider whose halves slide on one another [m].
nlohmann::json interface_report(const Response &r) {
  const auto &x = r.series("interface_slip_x"), &y = r.series("interface_slip_y");
  double largest = 0;
  for (std::size_t k = 0; k < x.size(); ++k) largest = std::max(largest, std::hypot(x[k], y[k]));
  return {{"largest_interface_slip_m", largest}, {"residual_interface_slip_m", std::hypot(x.back(), y.back())}};
}

Summary summarise(const scene::Scene &scene, const RunRecord &record) {
  const double seconds = record.wall_so_far();
  Summary summary;
  if (record.response.size() > 0) summarise_response(record.response, summary);
  summary.impacts = record.impacts; // exact instants and speeds, not those of the samples
  summary.energy = record.ledger;
  summary.rung = solved_by(scene.model.rung);
  summary.mesh = scene.model.mesh;
  summary.n_steps = record.n_steps;
  const SolverWork work = record.work_so_far();
  summary.n_newton_iterations = work.iterations;
  if (scene.excitation.kind == scene::ExcitationKind::window && !scene.excitation.with_weight)
    summary.min_normal_force.reset();
  summary.wall_time = seconds;
  summary.processor_time = ranks().all_reduce_sum(record.processor_so_far());
  summary.peak_memory_bytes = static_cast<long>(ranks().all_reduce_sum(static_cast<double>(peak_memory_bytes())));
  summary.n_dofs = record.n_dofs;
  summary.time_split = record.time_split;
  double output = seconds;
  for (const auto &[name, value] : record.time_split) output -= value;
  const auto &r = record.response;
  if (r.has("plastic_strain_max") && r.size() > 0) summary.max_plastic_strain = r.series("plastic_strain_max").back();
  if (r.has("energy_friction_seat") && r.size() > 0) {
    const auto largest = [&](const char *name) {
      const auto &series = r.series(name);
      return *std::max_element(series.begin(), series.end());
    };
    summary.extra["seat"] = {{"largest_pressure_on_bottom_Pa", largest("seat_pressure_max")},
                             {"largest_pressure_on_wall_Pa", largest("recess_pressure_max")},
                             {"friction_J", r.series("energy_friction_seat").back()}};
  }
  if (r.has("interface_slip_x") && r.size() > 0) summary.extra["interface"] = interface_report(r);
  summary.steel = record.steel;
  summary.foot = foot_report(record.response, scene.bearing);
  if (const auto &steel = scene.bearing.rim_steel(); steel.knows_rate())
    summary.extra["steel_rate"] = in_words(steel.rate);
  summary.time_split["output"] = std::max(0.0, output); // meshing, flights and files
  summary.extra["cuts"] = record.n_cuts;
  for (const auto &count : solver_counts) summary.extra["solver_work"][count.sum] = work.*count.of;
  summary.extra["augmentation_cap_reached"] = record.augmentation_caps;
  summary.extra["warnings"] = record.warnings;
  return summary;
}

} // namespace

meshes::HexMesh mesh_of(const scene::Scene &scene, const planning::Plan &plan) {
  return rung_of(scene.model.rung).mesh(scene.bearing, mesh_order(scene, plan));
}

bool is_first_rank() {
  return ranks().first();
}

bool on_any_rank(bool here) {
  return ranks().any(here);
}

bool is_interrupted(const RunOptions &options) {
  return ranks().any(options.interrupted && *options.interrupted);
}

void check_supported(const scene::Scene &scene) {
  if (const auto reason = planning::refusal(scene)) throw InputError(*reason);
}

namespace {

/// What to say of a push whose steel knows its rate: nothing of it takes time.
std::optional<std::string> doubt_of_rate(const scene::Scene &scene) {
  const scene::Material &steel = scene.bearing.rim_steel();
  if (!steel.knows_rate() || scene.excitation.kind != scene::ExcitationKind::push) return {};
  return fmt::format("a push is infinitely slow: the steel's law of the rate ({}) has no part in it",
                     in_words(steel.rate));
}

/// Whether the run goes on from the folder's checkpoint. Where the checkpoint holds nothing but the beginning it starts
/// afresh, and says so.
bool goes_on(const RunOptions &options, const RunRecord &record) {
  if (!options.resume) return false;
  const bool begun = has_only_begun(kept_checkpoint(options, record));
  if (begun && options.remark) options.remark("the run was ended before its first checkpoint: it starts afresh");
  return !begun;
}

void run_rung(const Rung &rung, const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options,
              RunRecord &record) {
  const bool in_time = scene.excitation.is_dynamic();
  const auto drive = !in_time ? run_path : rung.dish == DishKind::law ? run_flights : run_sliding;
  drive(rung, scene, plan, options, record);
}

/// How a run ended; a failure is thrown again once its folder is written.
struct Ending {
  RunStatus status = RunStatus::done;
  std::string reason = {};
  std::exception_ptr failure = {};
};

Ending carry_out(const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options, RunRecord &record) {
  const auto stopped = [](const std::string &reason) {
    return Ending{RunStatus::stopped, reason, std::make_exception_ptr(SolverStopped(reason))};
  };
  try {
    need_memory(plan.expected_memory_bytes);
    run_rung(rung_of(scene.model.rung), scene, plan, options, record);
    return {};
  } catch (const Interrupted &error) {
    return {RunStatus::interrupted, error.what(), std::current_exception()};
  } catch (const SolverStopped &error) {
    return {RunStatus::stopped, error.what(), std::current_exception()};
  } catch (const std::bad_alloc &) {
    return stopped("the limit of memory is reached; a coarser mesh (a lower model.mesh) needs less");
  } catch (const std::system_error &error) {
    if (error.code() != std::errc::resource_unavailable_try_again) throw;
    return stopped("the limit of threads or of memory is reached: a thread could not be started");
  }
}

} // namespace

Summary run(const scene::Scene &scene, const planning::Plan &plan, const RunOptions &given) {
  check_supported(scene);
  RunOptions options = given;
  RunRecord record;
  record.identity = to_json(identity_of(scene));
  std::error_code failed;
  if (options.writes) std::filesystem::create_directories(options.folder, failed);
  if (failed) throw IoError("cannot make the run folder " + options.folder + ": " + failed.message());
  options.resume = goes_on(options, record);
  if (!options.resume) begin_checkpoint(options, record);
  const auto [status, reason, failure] = carry_out(scene, plan, options, record);
  const auto doubt = failure ? std::nullopt : doubt_of_rebound(record.response, record.impacts);
  if (doubt) record.warnings.push_back(*doubt);
  for (const auto &found : {doubt_of_bounce(record.response), doubt_of_ledger(record.ledger),
                            doubt_of_contact(record.ledger, record.impacts, scene.load.mass), doubt_of_rate(scene)})
    if (found) record.warnings.push_back(*found);
  Summary summary = summarise(scene, record);
  summary.status = status;
  summary.reason = reason;
  if (doubt) leave_last_impact_open(record.response, summary);
  summary.extra["identity"] = record.identity;
  summary.extra["plan"] = to_json(plan);
  summary.extra["ranks"] = ranks().size;
  judge(scene, summary);
  if (!failure && options.annotate) options.annotate(summary);
  if (options.writes) {
    write_run_folder(options.folder, scene, record.response, summary);
    write_pvd(options, record);
  }
  if (failure) std::rethrow_exception(failure);
  return summary;
}

} // namespace rimpact::fe

// The quasi-static push of rung R1: the top face is driven beyond touch and back, the height following the
// dish.
#include "fe_contact/runner/rim_run.h"
#include "fe_contact/runner/sample_row.h"
#include "scene/error.h"

namespace rimpact::fe {
namespace {

struct Pusher {
  const scene::Scene &scene;
  const RunOptions &options;
  RimSolver &solver;
  RunRecord &record;
  reduced::PhysicalModel model;
  RimFrame frame;
  ArcState state;
  double step = 1e-5; ///< of travel [m]; the first contact wants a small one
  Eigen::Vector3d last_force = Eigen::Vector3d::Zero();

  Pusher(const scene::Scene &scene, const RunOptions &options, RimSolver &solver, RunRecord &record)
      : scene(scene), options(options), solver(solver), record(record), model(scene), state(solver.virgin()) {
    const double capacity = scene.bearing.lateral_capacity();
    frame = {scene.excitation.direction_deg * M_PI / 180, capacity, model.height(capacity, 0).z};
  }

  Eigen::Vector3d target(double travel) const {
    return {travel, 0, model.height(frame.lateral_capacity + travel, 0).z - frame.touch_height};
  }

  void sample(double parameter, const StepReport &report, double travel_step) {
    const Eigen::Vector3d u = frame.displacement(state.master), force = frame.to_global(report.rim_force);
    const Eigen::Vector3d none = Eigen::Vector3d::Zero();
    append(record, {parameter, u, none, force, none, none, force, {}, frame.lateral_capacity - u.head<2>().norm(),
                    std::min(state.report.smallest_gap, no_gap), solver.largest_plastic_strain(state),
                    state.report.largest_pressure, report.iterations, travel_step});
  }

  /// Moves to a travel in steps that grow while Newton likes them and halve where it does not.
  void advance(double travel, double parameter, double &reached) {
    constexpr double growth = 1.6, smallest = 1e-8;
    while (std::abs(travel - reached) > 1e-12) {
      if (is_interrupted(options)) throw Interrupted();
      const double to_go = travel - reached,
                   next = std::abs(to_go) <= step ? travel : reached + std::copysign(step, to_go);
      const Eigen::Vector3d before = state.master;
      const StepReport report = solver.push(state, target(next));
      record.n_newton += report.iterations;
      if (!report.converged) {
        ++record.n_cuts;
        step = 0.5 * std::abs(next - reached);
        if (step < smallest)
          throw SolverStopped("the push stopped at " + std::to_string(1e3 * reached) + " mm beyond touch: " +
                              report.reason + "; try a finer mesh or a smaller travel_mm");
        continue;
      }
      if (std::abs(next - reached) >= 0.99 * step) step *= growth;
      ++record.n_steps;
      record.ledger.external -= 0.5 * (report.rim_force + last_force).dot(state.master - before);
      last_force = report.rim_force;
      record.ledger.elastic = solver.share() * state.energies.elastic;
      record.ledger.plastic = solver.share() * state.energies.plastic;
      record.ledger.contact += report.contact_work;
      record.ledger.largest_input = std::max(record.ledger.largest_input, std::abs(record.ledger.external));
      sample(parameter, report, std::abs(next - reached));
      reached = next;
      if (options.progress)
        options.progress({parameter, 1.0, std::abs(next - reached), report.iterations,
                          state.report.smallest_gap, report.rim_force.head<2>().norm(), "push"});
    }
  }
};

} // namespace

void run_rim_push(const scene::Scene &scene, const RunOptions &options, RimSolver &solver,
                  RunRecord &record) {
  constexpr int steps_in = 32, steps_out = 64;
  Pusher pusher(scene, options, solver, record);
  const double travel = scene.excitation.travel * scene.excitation.scale,
               out = scene.excitation.unload ? 0.5 : 1.0;
  double reached = 0;
  pusher.sample(0, {}, 0);
  for (int n = 1; n <= steps_in; ++n) pusher.advance(travel * n / steps_in, out * n / steps_in, reached);
  write_fields(solver, pusher.state, pusher.frame, out, options, record);
  // Unloading is nearly elastic and short: fine steps until the walls part.
  for (int n = 1; scene.excitation.unload && n <= steps_out && pusher.state.report.active > 0; ++n)
    pusher.advance(travel * (1 - double(n) / steps_out), 0.5 + 0.5 * n / steps_out, reached);
  if (scene.excitation.unload) write_fields(solver, pusher.state, pusher.frame, 1.0, options, record);
}

} // namespace rimpact::fe

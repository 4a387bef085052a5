// The quasi-static push of rung rim: the top face is driven beyond touch and back, the height following the
// dish.
#include "fe_contact/drive/fields.h"
#include "fe_contact/drive/push_steps.h"
#include "fe_contact/drive/rim_run.h"
#include "fe_contact/drive/sample_row.h"
#include "files/error.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::fe {
namespace {

constexpr int steps_in = 32, steps_out = 64;

struct Pusher {
  const scene::Scene &scene;
  const RunOptions &options;
  RimSystem &system;
  RunRecord &record;
  reduced::PhysicalModel model;
  RimFrame frame;
  SystemState state;
  StepOptions step_options;
  Eigen::Vector3d last_force = Eigen::Vector3d::Zero();
  double travel, deepest_at; ///< [m]; load parameter of the deepest point

  Pusher(const scene::Scene &scene, const RunOptions &options, RimSystem &system, RunRecord &record)
      : scene(scene), options(options), system(system), record(record), model(scene), state(system.at_rest()),
        step_options(rim_step_options(scene)), travel(scene.excitation.travel * scene.excitation.scale),
        deepest_at(scene.excitation.unload ? 0.5 : 1.0) {
    const double capacity = scene.bearing.lateral_capacity();
    frame = {scene.excitation.direction_deg * M_PI / 180, capacity, model.height(capacity, 0).z};
  }

  /// Beyond touch at load parameter s [m].
  double travel_at(double s) const {
    return s <= deepest_at ? travel * s / deepest_at : travel * (1 - s) / (1 - deepest_at);
  }
  Eigen::Vector3d target(double way) const {
    return {way, 0, model.height(frame.lateral_capacity + way, 0).z - frame.touch_height};
  }

  void sample(double s, int iterations, double travel_step) {
    const Eigen::Vector3d u = frame.displacement(system.top().of(state.u)),
                          force = frame.to_global(system.wall_force(state));
    const Eigen::Vector3d none = Eigen::Vector3d::Zero();
    const SurfaceContactReport &wall = state.reports[0];
    append(record, {s,
                    u,
                    none,
                    force,
                    none,
                    none,
                    force,
                    {},
                    frame.lateral_capacity - u.head<2>().norm(),
                    std::min(wall.smallest_gap, no_gap),
                    largest_plastic_strain(state.history),
                    wall.largest_pressure,
                    iterations,
                    travel_step});
  }

  void account(const Eigen::Vector3d &before) {
    const double share = system.model().share();
    const Eigen::Vector3d force = system.wall_force(state);
    auto &ledger = record.ledger;
    ledger.external -= 0.5 * (force + last_force).dot(system.top().of(state.u) - before);
    ledger.elastic = share * state.energies.elastic;
    ledger.plastic = share * state.energies.plastic;
    ledger.contact += share * state.reports[0].normal_work;
    ledger.friction += share * state.reports[0].friction_work;
    ledger.largest_input = std::max(ledger.largest_input, std::abs(ledger.external));
    last_force = force;
  }

  Attempt attempt(double s, double ds) {
    if (is_interrupted(options)) throw Interrupted();
    const Eigen::Vector3d before = system.top().of(state.u);
    const double step = std::abs(travel_at(s + ds) - travel_at(s));
    const ContactStepReport report = system.push(state, target(travel_at(s + ds)), step_options);
    if (!report.converged) return {false, 0, report.reason};
    ++record.n_steps;
    account(before);
    sample(s + ds, report.iterations, step);
    if (options.progress)
      options.progress(
          {s + ds, 1.0, step, report.iterations, state.reports[0].smallest_gap, last_force.head<2>().norm(), "push"});
    return {true, growth * ds, {}, s >= deepest_at && state.bearing_points() == 0}; // unloaded, the walls part
  }

  /// `per_metre`: load parameter over travel.
  void follow(double from, double to, int steps, double per_metre) {
    const double longest = (to - from) / steps;
    const MarchReport report =
        march(from, to, {std::min(first_step * per_metre, longest), smallest_step * per_metre, longest, growth},
              [&](double s, double ds) { return attempt(s, ds); });
    record.n_cuts += report.cuts;
    if (!report.finished)
      throw SolverStopped(
          fmt::format("the push stopped at {:.4f} mm beyond touch: {}; try a finer mesh or a smaller travel_mm",
                      1e3 * travel_at(report.reached), report.reason));
  }

  void write_fields(double s) {
    fe::write_fields(system, state, system.expand(state), "rim", s, options, record, frame.direction * 180 / M_PI);
  }
};

} // namespace

void run_rim_push(const scene::Scene &scene, const RunOptions &options, RimSystem &system, RunRecord &record) {
  Pusher pusher(scene, options, system, record);
  pusher.sample(0, 0, 0);
  pusher.follow(0, pusher.deepest_at, steps_in, pusher.deepest_at / pusher.travel);
  pusher.write_fields(pusher.deepest_at);
  if (!scene.excitation.unload) return;
  // Unloading is nearly elastic and short: fine steps until the walls part.
  pusher.follow(pusher.deepest_at, 1, steps_out, (1 - pusher.deepest_at) / pusher.travel);
  pusher.write_fields(1);
}

} // namespace rimpact::fe

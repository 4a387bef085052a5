// Quasi-static paths of rungs rigid-dish and full: preload under the dead load, then the top face is driven along the
// path, of a push into the rim and back.
#include "fe_contact/drive/fields.h"
#include "fe_contact/drive/record_checkpoint.h"
#include "fe_contact/drive/stack_drive.h"
#include "fe_contact/drive/stack_recorder.h"
#include "fe_contact/drive/stack_run.h"
#include "fe_contact/drive/system_checkpoint.h"
#include "files/error.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <tuple>

namespace rimpact::fe {
namespace {

struct StaticPath {
  const scene::Scene &scene;
  const RunOptions &options;
  RunRecord &record;
  StackModel model;
  StackSystem system;
  SystemState state;
  StackRecorder recorder;
  TopDrive drive;
  Eigen::VectorXd load;
  StepOptions step_options = stack_step_options();
  static constexpr double growth = 2; ///< of the next step: by this one alone, so that a checkpoint holds it
  double rest_height = 0;             ///< of the top face under the load [m]

  StaticPath(const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options, RunRecord &record)
      : scene(scene), options(options), record(record),
        model(scene.bearing, stack_mesh_options(scene, plan), true, scene.model.penalty_scale),
        system(model, model.full() || plan.rim_takes_part), state(system.at_rest()), recorder(scene, model, record),
        load(system.dead_load(scene.load.vertical)) {
    record.n_dofs = system.equations().n;
  }

  Attempt attempt(double s, double ds) {
    if (is_interrupted(options)) throw Interrupted();
    const Eigen::Vector2d target =
        scene::prescribed_displacement(scene.excitation, scene.bearing.lateral_capacity(), s + ds);
    const Eigen::Vector3d before = system.top_of(state.u), force_before = forces_of(model, state).total();
    const ContactStepReport step = drive.move_to(system, state, target, load, step_options);
    if (!step.converged) {
      ++record.n_cuts;
      return {false, 0, step.reason};
    }
    ++record.n_steps;
    record.augmentation_caps += step.capped;
    account(before, force_before);
    sample(s + ds, step.iterations, ds);
    if (options.progress)
      options.progress({s + ds, 1.0, ds, step.iterations, scene.bearing.lateral_capacity() - target.norm(),
                        forces_of(model, state).total().head<2>().norm(),
                        forces_of(model, state).rim.any() ? "pressing" : "sliding"});
    return {true, growth * ds, {}};
  }

  void account(const Eigen::Vector3d &before, const Eigen::Vector3d &force_before) {
    const Eigen::Vector3d du = system.top_of(state.u) - before;
    auto &ledger = record.ledger;
    ledger.external -= 0.5 * (force_before + forces_of(model, state).total()).head<2>().dot(du.head<2>());
    ledger.gravity += scene.load.vertical * du.z();
    ledger.elastic = model.share() * state.energies.elastic - rest_elastic;
    ledger.plastic = model.share() * state.energies.plastic;
    for (const auto &report : state.reports) {
      ledger.friction += model.share() * report.friction_work;
      ledger.contact += model.share() * report.normal_work;
    }
    ledger.largest_input = std::max(ledger.largest_input, std::abs(ledger.external));
  }

  void sample(double s, int iterations, double ds) {
    recorder.sample(s, system.top_of(state.u) - Eigen::Vector3d(0, 0, rest_height), Eigen::Vector3d::Zero(), state,
                    iterations, ds);
  }
  void write_fields(double s) { fe::write_fields(system, state, system.expand(state), "stack", s, options, record); }

  double rest_elastic = 0; ///< energy of the preload, not counted [J]

  /// ds: the next step.
  void save(double s, double ds) {
    if (options.folder.empty()) return;
    system.start_afresh_at(state); // as the run that reads it will
    if (!options.writes) return;
    Checkpoint file;
    put(file, record);
    put(file, state);
    file.numbers["path"] = {s, ds, rest_height, rest_elastic, drive.last_way.x(), drive.last_way.y()};
    file.numbers["drive_change"] = list(drive.last_change);
    write_checkpoint(file, checkpoint_of(options));
  }

  /// Where the kept run stopped, and its next step.
  std::pair<double, double> restore() {
    const Checkpoint file = kept_checkpoint(options, record);
    get(file, record);
    get(file, state);
    const auto &p = file.field("path", 6);
    if (p[0] < 0 || p[0] > 1 || p[1] < 0 || p[1] > 1) file.damaged("field path holds a number it cannot");
    rest_height = p[2], rest_elastic = p[3], drive.last_way = {p[4], p[5]};
    drive.last_change = vector(drive.last_way.squaredNorm() > 0 ? file.field("drive_change", state.u.size())
                                                                : file.field("drive_change"));
    system.start_afresh_at(state);
    return {p[0], p[1]};
  }

  struct Phase {
    double end, first, largest; ///< of the load parameter
  };
  /// Of a push: out to the rim, into it, back.
  std::vector<Phase> phases() const {
    constexpr double steps_a_cycle = 160, longest_slide = 0.025; // [m]
    constexpr double steps_in = 32, steps_back = 32;
    const auto &e = scene.excitation;
    std::vector<double> ends = scene::prescribed_breakpoints(e);
    if (ends.empty()) {
      const double largest = 1 / (steps_a_cycle * cycles());
      return {{1, 1e-3 * largest, largest}};
    }
    ends.push_back(1);
    const double slide = ends[0] * longest_slide / scene.bearing.lateral_capacity(),
                 in = (ends[1] - ends[0]) / steps_in;
    std::vector<Phase> result{{ends[0], 1e-3 * slide, slide}, {ends[1], 1e-2 * in, in}};
    if (ends.size() > 2) result.push_back({1, 0.1 * (1 - ends[1]) / steps_back, (1 - ends[1]) / steps_back});
    return result;
  }
  double cycles() const {
    return scene.excitation.kind == scene::ExcitationKind::cyclic ? scene.excitation.cycles : 1.0;
  }

  void run() {
    double reached = 0, next = 0; // next step; 0: the phase's first
    if (options.resume) {
      std::tie(reached, next) = restore();
    } else {
      preload_stack(system, state, load, step_options);
      rest_height = system.top_of(state.u).z();
      rest_elastic = model.share() * state.energies.elastic;
      sample(0, 0, 0);
      write_fields(0);
      save(0, 0);
    }
    if (record.ended) return;
    for (const Phase &phase : phases()) {
      if (reached > phase.end - 1e-9) continue;
      reached = follow(reached, phase, next > 0 ? next : phase.first);
      next = 0;
    }
    record.ended = true;
    save(1, 0);
  }

  double follow(double start, const Phase &phase, double first) {
    constexpr int checkpoint_every = 10;
    const double picture = 0.25 / cycles();
    const MarchReport report =
        march(start, phase.end, {first, 1e-8 * phase.largest, phase.largest, growth}, [&](double s, double ds) {
          Attempt result = attempt(s, ds);
          if (!result.accepted) return result;
          if (std::floor((s + ds) / picture + 1e-9) > std::floor(s / picture + 1e-9)) write_fields(s + ds);
          if (record.n_steps % checkpoint_every == 0) save(s + ds, growth * ds);
          return result;
        });
    if (report.finished) return phase.end;
    save(report.reached, phase.largest);
    throw SolverStopped(fmt::format("the path stopped at load parameter {:.4f}: {}; partial results are kept; try "
                                    "--mesh 2, or go on with --resume",
                                    report.reached, report.reason));
  }
};

} // namespace

void run_stack_static(const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options,
                      RunRecord &record) {
  StaticPath path(scene, plan, options, record);
  run_counted(
      record, [&] { path.run(); }, [&] { return path.system.time_split; }, [&] { return path.system.work; });
}

} // namespace rimpact::fe

#include "fe_contact/drive/path_run.h"

#include "fe_contact/drive/fields.h"
#include "fe_contact/drive/forces.h"
#include "fe_contact/drive/order.h"
#include "fe_contact/drive/path_course.h"
#include "fe_contact/drive/path_work.h"
#include "fe_contact/drive/record_checkpoint.h"
#include "fe_contact/drive/system_checkpoint.h"
#include "files/error.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <tuple>

namespace rimpact::fe {
namespace {

constexpr int steps_a_save = 10;

class PathRun {
public:
  PathRun(const Rung &rung, const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options,
          RunRecord &record)
      : scene_(scene), options_(options), record_(record), on_dish_(rung.dish != DishKind::law),
        course_(on_dish_ ? course_on_dish(scene) : course_from_touch(scene)),
        model_(rung, scene.bearing, mesh_order(scene, plan), model_options(scene)),
        system_(model_, 0, rung.dish != DishKind::exact || plan.rim_takes_part ? RimState::solid : RimState::held),
        state_(system_.at_rest()), load_(system_.dead_load(on_dish_ ? scene.load.vertical : 0)),
        steps_(step_options(rung, scene)) {
    record.n_dofs = system_.equations().n;
  }

  void run() {
    double reached = 0, next = 0; // next step; 0: the phase's first
    if (options_.resume)
      std::tie(reached, next) = restore();
    else
      begin();
    if (record_.ended) return;
    for (const PathCourse::Phase &phase : course_.phases) {
      if (reached > phase.end - 1e-9) continue;
      reached = follow(reached, phase, next > 0 ? next : phase.first);
      next = 0;
    }
    if (pictured_ < 1 - 1e-9) write_fields(1);
    record_.ended = true;
    save(1, 0);
  }
  const BearingSystem &system() const { return system_; }
  SteelReport steel() const { return steel_of(model_, state_, course_.frame); }

private:
  void begin() {
    if (on_dish_) preload_on_dish(system_, state_, load_, steps_);
    rest_height_ = system_.top_of(state_.u).z();
    rest_elastic_ = model_.share() * state_.energies.elastic;
    sample(0, 0, 0, forces());
    if (on_dish_) write_fields(0);
    save(0, 0);
  }

  /// To the phase's end, or to where the walls part. Returns what was reached: in both cases the phase's end.
  double follow(double start, const PathCourse::Phase &phase, double first) {
    const MarchReport report = march(start, phase.end, {first, phase.smallest, phase.largest, course_.growth},
                                     [&](double s, double ds) { return attempt(s, ds); });
    record_.n_cuts += report.cuts;
    if (report.finished) return phase.end;
    save(report.reached, phase.largest);
    const TopTarget top = course_.top(report.reached);
    throw SolverStopped(fmt::format("the path stopped at load parameter {:.4f}, {:.4f} mm from its start: {}; partial "
                                    "results are kept; try a finer mesh, or go on with --resume",
                                    report.reached, 1e3 * top.plane.norm(), report.reason));
  }

  Attempt attempt(double s, double ds) {
    if (is_interrupted(options_)) throw Interrupted();
    TopTarget target = course_.top(s + ds);
    target.dt = course_.duration(s, ds);
    const Eigen::Vector3d before = system_.top_of(state_.u), force_before = forces().total();
    const ContactStepReport step = drive_.move_to(system_, state_, target, load_, steps_);
    if (!step.converged) return {false, 0, step.reason};
    ++record_.n_steps;
    record_.augmentation_caps += step.capped;
    const BearingForces now = forces();
    account(before, force_before, now.total(), target.height.has_value());
    sample(s + ds, step.iterations, ds, now);
    if (options_.progress)
      options_.progress({s + ds, 1.0, ds, step.iterations, gap(), now.total().head<2>().norm(),
                         now.rim.any() ? Phase::pressing : Phase::sliding});
    const double part = course_.picture;
    if (std::floor((s + ds) / part + 1e-9) > std::floor(s / part + 1e-9)) write_fields(s + ds);
    const bool parted = s >= course_.parts_from && state_.bearing_points() == 0;
    if (!parted && record_.n_steps % steps_a_save == 0) save(s + ds, course_.growth * ds);
    return {true, course_.growth * ds, {}, parted};
  }

  /// In the plate's frame.
  BearingForces forces() const {
    BearingForces result = forces_of(system_, state_);
    if (course_.frame)
      for (auto *force : {&result.pendular, &result.friction, &result.rim}) *force = course_.frame->to_global(*force);
    return result;
  }
  /// Of the slider from rest on the vertex, in the plate's frame [m].
  Eigen::Vector3d displacement(const Eigen::Vector3d &top) const {
    return course_.frame ? course_.frame->displacement(top) : top - Eigen::Vector3d(0, 0, rest_height_);
  }
  double gap() const {
    return scene_.bearing.lateral_capacity() - displacement(system_.top_of(state_.u)).head<2>().norm();
  }

  void account(const Eigen::Vector3d &top_before, const Eigen::Vector3d &force_before, const Eigen::Vector3d &force,
               bool height_driven) {
    const Eigen::Vector3d top = system_.top_of(state_.u);
    Eigen::Vector3d du = displacement(top) - displacement(top_before);
    auto &ledger = record_.ledger;
    if (on_dish_) ledger.gravity += scene_.load.vertical * du.z();
    if (!height_driven) du.z() = 0;
    ledger.external -= work_.add(force_before, force, du);
    ledger.elastic = model_.share() * state_.energies.elastic - rest_elastic_;
    ledger.plastic = model_.share() * state_.energies.plastic;
    for (const auto &report : state_.reports) {
      ledger.friction += model_.share() * report.friction_work;
      ledger.contact += model_.share() * report.normal_work;
    }
    ledger.largest_input = std::max(ledger.largest_input, std::abs(ledger.external));
  }

  void sample(double s, int iterations, double ds, const BearingForces &now) {
    fe::sample(record_, system_, state_,
               {s, displacement(system_.top_of(state_.u)), Eigen::Vector3d::Zero(), now, gap(), iterations, ds});
  }
  void write_fields(double s) {
    std::optional<double> direction;
    if (course_.frame) direction = course_.frame->direction * 180 / M_PI;
    fe::write_fields(system_, state_, system_.expand(state_), s, options_, record_, direction);
    pictured_ = s;
  }

  /// ds: the next step.
  void save(double s, double ds) {
    if (options_.folder.empty()) return;
    system_.start_afresh_at(state_); // as the run that reads it will
    if (!options_.writes) return;
    Checkpoint file;
    put(file, record_);
    put(file, state_);
    file.numbers["path"] = {s, ds, rest_height_, rest_elastic_, pictured_};
    file.numbers["path_way"] = list(work_.way);
    file.numbers["path_change"] = list(work_.change);
    file.numbers["drive_way"] = list(drive_.last_way);
    file.numbers["drive_change"] = list(drive_.last_change);
    write_checkpoint(file, checkpoint_of(options_));
  }

  /// Where the kept run stopped, and its next step.
  std::pair<double, double> restore() {
    const Checkpoint file = kept_checkpoint(options_, record_);
    get(file, record_);
    get(file, state_);
    const auto &p = file.field("path", 5);
    if (p[0] < 0 || p[0] > 1 || p[1] < 0 || p[1] > 1 || p[4] < -1 || p[4] > 1)
      file.damaged("field path holds a number it cannot");
    rest_height_ = p[2], rest_elastic_ = p[3], pictured_ = p[4];
    work_ = {vector(file.field("path_way", 3)), vector(file.field("path_change", 3))};
    drive_.last_way = vector(file.field("drive_way", 3));
    drive_.last_change = vector(drive_.last_way.squaredNorm() > 0 ? file.field("drive_change", state_.u.size())
                                                                  : file.field("drive_change"));
    system_.start_afresh_at(state_);
    return {p[0], p[1]};
  }

  const scene::Scene &scene_;
  const RunOptions &options_;
  RunRecord &record_;
  const bool on_dish_;
  const PathCourse course_;
  const BearingModel model_;
  BearingSystem system_;
  SystemState state_;
  const Eigen::VectorXd load_;
  const StepOptions steps_;
  TopDrive drive_;
  PathWork work_;
  double rest_height_ = 0;  ///< of the top face under the load [m]
  double rest_elastic_ = 0; ///< energy of the preload, not counted [J]
  double pictured_ = -1;    ///< load parameter of the last fields; -1: none
};

} // namespace

void run_path(const Rung &rung, const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options,
              RunRecord &record) {
  PathRun path(rung, scene, plan, options, record);
  run_counted(
      record, [&] { path.run(); }, [&] { return path.system().time_split; }, [&] { return path.system().work; },
      [&] { return path.steel(); });
}

} // namespace rimpact::fe

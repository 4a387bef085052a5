#include "fe_contact/drive/path_run.h"

#include "fe_contact/drive/drive.h"
#include "fe_contact/drive/fields.h"
#include "fe_contact/drive/forces.h"
#include "fe_contact/drive/ledger.h"
#include "fe_contact/drive/order.h"
#include "fe_contact/drive/path_course.h"
#include "fe_contact/drive/path_work.h"
#include "fe_contact/drive/record_checkpoint.h"
#include "fe_contact/drive/state_fields.h"
#include "io/files/error.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::fe {
namespace {

constexpr int steps_a_checkpoint = 10;

class PathRun : public Drive {
public:
  PathRun(const Rung &rung, const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options,
          RunRecord &record)
      : Drive(options, record, steps_a_checkpoint), scene_(scene), on_dish_(rung.dish != DishKind::law),
        course_(on_dish_ ? course_on_dish(scene) : course_from_touch(scene)),
        model_(rung, scene.bearing, mesh_order(scene, plan), model_options(scene)),
        system_(model_, 0, rung.dish != DishKind::exact || plan.rim_takes_part ? RimState::solid : RimState::held),
        state_(system_.at_rest()), load_(system_.dead_load(on_dish_ ? scene.load.vertical : 0)),
        steps_(step_options(rung, scene)) {
    record.n_dofs = system_.equations().n;
  }

  void run() {
    if (options_.resume)
      restore(kept_checkpoint(options_, record_));
    else
      begin();
    if (record_.ended) return;
    for (const PathCourse::Phase &phase : course_.phases) {
      if (reached_ > phase.end + 1e-9) continue;
      if (reached_ > phase.end - 1e-9) { // a checkpoint at its end
        next_step_ = 0;
        continue;
      }
      push(phase);
      next_step_ = 0;
    }
    if (pictured_ < 1 - 1e-9) write_fields(1);
    record_.ended = true;
    save();
  }
  const BearingSystem &solids() const { return system_; }
  SteelReport steel() const { return steel_of(model_, state_, course_.frame); }

private:
  void begin() {
    if (on_dish_) preload_on_dish(system_, state_, load_, steps_);
    rest_height_ = system_.top_of(state_.u).z();
    rest_elastic_ = model_.energy_share() * state_.energies.elastic;
    sample(0, 0, forces());
    if (on_dish_) write_fields(0);
    save();
  }

  /// To the phase's end, or to where the walls part: what is reached is in both cases the phase's end.
  void push(const PathCourse::Phase &phase) {
    const double first = next_step_ > 0 ? next_step_ : phase.first;
    const MarchReport report = stretch_to(reached_, phase.end, {first, phase.smallest, phase.largest, course_.growth});
    reached_ = report.finished ? phase.end : report.reached;
    if (report.finished) return;
    next_step_ = phase.largest;
    save();
    const TopTarget top = course_.top(report.reached);
    throw SolverStopped(fmt::format("the path stopped at load parameter {:.4f}, {:.4f} mm from its start: {}; partial "
                                    "results are kept; try a finer mesh, or go on with --resume",
                                    report.reached, 1e3 * (on_dish_ ? model_.rate_ratio : 1) * top.plane.norm(),
                                    report.reason));
  }

  ContactSystem &system() override { return system_; }
  SystemState &state() override { return state_; }

  /// A path that goes on into the rim comes to it, and touches it with a short step: what its force does is summed up
  /// from steps.
  double clipped(double s, double ds) const override {
    constexpr double near = 1e-4, touching_way = 2e-4; // [m]
    if (!on_dish_ || scene_.excitation.kind == scene::ExcitationKind::push || system_.walls_touch(state_)) return 0;
    const double left = gap(), ahead = gap_at(course_.top(s + ds).plane * model_.rate_ratio);
    if (ahead >= 0 || left <= ahead) return 0;
    const double way = left > near ? left - near / 2 : touching_way;
    return way < 0.99 * (left - ahead) ? ds * way / (left - ahead) : 0;
  }
  ContactStepReport solve(double s, double ds) override {
    target_ = course_.top(s + ds);
    target_.dt = course_.duration(s, ds);
    top_before_ = system_.top_of(state_.u), force_before_ = forces().total();
    return drive_.move_to(system_, state_, target_, load_, steps_);
  }

  std::vector<Event> events(const SolvedStep &step) const override {
    if (step.t >= course_.parts_from && !system_.walls_touch(state_)) return {Event::release};
    return {};
  }
  bool take(const std::vector<Event> &events) override { return !events.empty(); }
  Attempt assess(const SolvedStep &step) override { return {true, course_.growth * step.dt, {}}; }

  void follow(const SolvedStep &step) override {
    const double s = step.end(), part = course_.picture;
    const BearingForces now = forces();
    reached_ = s;
    account(now.total());
    sample(step.report.iterations, step.dt, now);
    if (options_.progress)
      options_.progress({s, 1.0, step.dt, step.report.iterations, gap(), now.total().head<2>().norm(),
                         now.rim.any() ? Phase::pressing : Phase::sliding});
    if (std::floor(s / part + 1e-9) > std::floor(step.t / part + 1e-9)) write_fields(s);
    stop_for(stop_of_halves(system_, state_, fmt::format("load parameter {:.4f}", s)));
  }

  /// In the plate's frame.
  BearingForces forces() const {
    BearingForces result = forces_of(system_, state_);
    if (course_.frame)
      for (auto *force : {&result.pendular, &result.friction, &result.rim}) *force = course_.frame->force(*force);
    return result;
  }
  /// Of what is carried, from rest on the vertex, in the plate's frame [m].
  Eigen::Vector3d displacement(const Eigen::Vector3d &top) const {
    if (course_.frame) return course_.frame->displacement(top);
    return model_.rate_ratio * (top - Eigen::Vector3d(0, 0, rest_height_));
  }
  double gap() const { return gap_at(displacement(system_.top_of(state_.u)).head<2>()); }
  /// At a travel of what is carried, the slider's halves as they are [m].
  double gap_at(const Eigen::Vector2d &travel) const {
    return scene_.bearing.lateral_capacity() - (travel - system_.interface_slip(state_.u).head<2>()).norm();
  }

  void account(const Eigen::Vector3d &force) {
    Eigen::Vector3d du = displacement(system_.top_of(state_.u)) - displacement(top_before_);
    StepEnergies energies = energies_of(system_, state_, {}, model_.energy_share());
    energies.kinetic = 0;
    energies.elastic -= rest_elastic_;
    if (on_dish_) energies.gravity = scene_.load.vertical * du.z();
    if (!target_.height) du.z() = 0;
    energies.external = -work_.add(force_before_, force, du);
    book(record_.ledger, energies);
  }

  void sample(int iterations, double ds, const BearingForces &now) {
    fe::sample(record_, system_, state_,
               {reached_, displacement(system_.top_of(state_.u)), Eigen::Vector3d::Zero(), now, gap(), iterations, ds});
  }
  void write_fields(double s) {
    std::optional<double> direction;
    if (course_.frame) direction = course_.frame->direction * 180 / M_PI;
    fe::write_fields(system_, state_, system_.expand(state_), s, options_, record_, direction);
    pictured_ = s;
  }

  void visit(StateVisitor &v) override {
    fe::visit(v, state_);
    v.number("reached", reached_, {0, 1});
    v.number("next_step", next_step_, {0, 1});
    v.number("rest_height", rest_height_);
    v.number("rest_elastic", rest_elastic_);
    v.number("pictured", pictured_, {-1, 1});
    v.point("work_way", work_.way);
    v.point("work_change", work_.change);
    v.part("drive", [&] { fe::visit(v, drive_, state_.u.size()); });
  }

  const scene::Scene &scene_;
  const bool on_dish_;
  const PathCourse course_;
  const BearingModel model_;
  BearingSystem system_;
  SystemState state_;
  const Eigen::VectorXd load_;
  const StepOptions steps_;
  TopDrive drive_;
  PathWork work_;
  TopTarget target_{};                        ///< of the step
  Eigen::Vector3d top_before_, force_before_; ///< at the step's start [m], [N]
  double reached_ = 0;                        ///< load parameter
  double rest_height_ = 0;                    ///< of the top face under the load [m]
  double rest_elastic_ = 0;                   ///< energy of the preload, not counted [J]
  double pictured_ = -1;                      ///< load parameter of the last fields; -1: none
};

} // namespace

void run_path(const Rung &rung, const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options,
              RunRecord &record) {
  PathRun path(rung, scene, plan, options, record);
  run_counted(
      record, [&] { path.run(); }, [&] { return path.solids().time_split; }, [&] { return path.solids().work; },
      [&] { return path.steel(); });
}

} // namespace rimpact::fe

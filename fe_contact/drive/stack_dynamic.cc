#include "fe_contact/drive/stack_dynamic.h"

#include "fe_contact/drive/fields.h"
#include "fe_contact/drive/kept_slide.h"
#include "fe_contact/drive/record_checkpoint.h"
#include "fe_contact/drive/stack_run.h"
#include "files/error.h"
#include "reduced_models/physical_model.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>

namespace rimpact::fe {
namespace {

constexpr double turning_step = 5e-4; // the slider turns round in steps of this [s]
constexpr double joining_gap = 2e-3;  // the rim's solids join here [m]
constexpr double parting_gap = 1e-3;  // and leave here, the walls moving apart [m]
constexpr double first_gap = 5e-5;    // a window starts here [m]
constexpr int checkpoint_every = 25;

bool has_friction(const scene::Scene &scene) {
  return scene.excitation.kind != scene::ExcitationKind::window || scene.excitation.with_friction;
}

/// Of the mass as it comes to the rim at a window's speed, by the reduced model [m/s^2].
Eigen::Vector3d arriving_acceleration(const scene::Scene &scene) {
  const reduced::PhysicalModel model(scene);
  reduced::BearingState state;
  const Eigen::Vector2d direction = scene.excitation.direction();
  const scene::SurfacePoint surface =
      model.height(scene.bearing.lateral_capacity() * direction.x(), scene.bearing.lateral_capacity() * direction.y());
  state.u << scene.bearing.lateral_capacity() * direction, surface.z;
  state.v << scene.excitation.impact_speed() * direction, 0;
  state.v.z() = surface.gradient.dot(state.v.head<2>());
  const reduced::BearingForces forces = model.forces(state);
  return (forces.pendular + forces.friction) / scene.load.mass -
         scene.load.vertical / scene.load.mass * Eigen::Vector3d::UnitZ();
}

} // namespace

StackDynamic::StackDynamic(const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options,
                           RunRecord &record)
    : scene_(scene), plan_(plan), options_(options), record_(record),
      model_(scene.bearing, stack_mesh_options(scene, plan), has_friction(scene), scene.model.penalty_scale),
      alone_(model_, false), joined_(model_, true), recorder_(scene, model_, record),
      ground_(scene.excitation, scene.load.gravity) {
  const double mass = scene.load.mass - model_.own_mass();
  alone_.carry(mass);
  joined_.carry(mass);
  transient_.step = stack_step_options();
  transient_.step.rho_inf = scene.model.rho_inf;
  transient_.contact_step = 0.1 * plan.step_in_contact;
  transient_.smallest_step = 1e-3 * plan.step_in_contact;
  transient_.energy_tolerance = 2e-5;
  transient_.gain_tolerance = 5e-4; // single steps at release give some back
  record.n_dofs = joined_.equations().n;
}

std::optional<double> StackDynamic::run() {
  if (record_.ended) return {};
  while (t_ < end_time() - 1e-12) {
    if (!near_rim_ && gap() < joining_gap && closing_speed() > 0) {
      if (const auto direction = unmeshed_direction()) return direction;
      join();
    }
    march_on();
  }
  write_fields();
  if (near_rim_ && touched_) record_.impacts.push_back(impact_);
  record_.ended = true;
  save();
  return {};
}

void StackDynamic::start() {
  state_ = active().at_rest();
  if (scene_.excitation.kind == scene::ExcitationKind::window)
    slide_out();
  else
    come_to_rest();
  rest_elastic_ = model_.share() * state_.energies.elastic;
  rest_plastic_ = model_.share() * state_.energies.plastic; // yielded on the way out
  height_before_ = travel().z();
  auto &ledger = report_.ledger;
  ledger.kinetic = active().kinetic_energy(state_);
  ledger.elastic = state_.energies.elastic;
  ledger.plastic = state_.energies.plastic;
  ledger.initial = ledger.largest = ledger.kinetic + ledger.elastic + ledger.plastic;
  record_.ledger.initial = record_.ledger.kinetic = record_.ledger.largest_input = model_.share() * ledger.kinetic;
  next_step_ = transient_.smallest_step;
  recorder_.sample(0, travel(), active().top_of(state_.v), state_, 0, 0);
  write_fields();
  active().start_afresh_at(state_); // as the run that reads it will
  save();
}

void StackDynamic::slide_to(TopDrive &drive, double from, double to, double first, double longest,
                            const Eigen::VectorXd &load) {
  const Eigen::Vector2d direction = scene_.excitation.direction();
  const double end = scene_.bearing.lateral_capacity() - first_gap;
  const auto go = [&](double at, double step) {
    if (is_interrupted(options_)) throw Interrupted();
    const auto report = drive.move_to(active(), state_, (at + step) * direction, load, transient_.step);
    if (options_.progress)
      options_.progress({0, end_time(), step, report.iterations, end - at - step, 0, "sliding out"});
    return Attempt{report.converged, 0, report.reason};
  };
  const MarchReport report = march(from, to, {first, 1e-5 * longest, longest, 2.0}, go);
  if (!report.finished) throw SolverStopped("the slide out to the rim stopped: " + report.reason);
}

void StackDynamic::come_to_rest() {
  preload_stack(active(), state_, active().dead_load(scene_.load.vertical), transient_.step);
  rest_height_ = active().top_of(state_.u).z();
}

/// At rest on the vertex, then to the last stretch before the rim, under the dead load; or what is kept of it.
void StackDynamic::slide_near(TopDrive &drive, double to) {
  constexpr double longest = 0.025; // step [m]
  const KeptSlide kept(scene_, plan_, options_);
  if (!kept.take(active(), state_, drive, rest_height_)) {
    come_to_rest();
    slide_to(drive, 0, to, 1e-3 * longest, longest, active().dead_load(scene_.load.vertical));
    kept.keep(state_, drive, rest_height_);
  }
  active().start_afresh_at(state_); // as the run that takes it will
}

void StackDynamic::slide_out() {
  constexpr double last = 1e-3; // the stretch on which the dish takes the load of the arriving mass [m]
  const Eigen::Vector2d direction = scene_.excitation.direction();
  const double end = scene_.bearing.lateral_capacity() - first_gap;
  TopDrive drive;
  slide_near(drive, end - last);
  // As if it came sliding at its speed: the dish carries the weight less what the path's curve takes off.
  const Eigen::VectorXd load =
      active().dead_load(scene_.load.vertical + scene_.load.mass * arriving_acceleration(scene_).z());
  slide_to(drive, end - last, end, 0.1 * last, 0.3 * last, load);
  // What the dish takes on the last stretch is added, so that the walls meet at the speed asked for. Under rung full
  // the plate dips, and its rim leans away by some micrometres: a graze would stop short of it.
  const double slowing = -forces_of(model_, state_).dish.head<2>().dot(direction) / scene_.load.mass;
  const double speed = std::sqrt(std::pow(scene_.excitation.impact_speed(), 2) + 2 * slowing * wall_gap());
  state_.v = drive.last_change * (speed / drive.last_way.norm());
}

Eigen::VectorXd StackDynamic::load(double t) const {
  const StackSystem &system = active();
  return system.dead_load(scene_.load.vertical) + system.gravity(-ground_.acceleration(t));
}

/// One phase: the stack sliding, at rest, or with the rim.
void StackDynamic::march_on() {
  resting_ = rests();
  transient_.step.rho_inf =
      resting_ ? 0 : scene_.model.rho_inf; // what rings on, of springs without damping, is of no interest
  const double longest = near_rim_  ? plan_.step_in_contact
                         : resting_ ? planning::longest_resting_step
                                    : longest_sliding_step;
  const MarchReport report = march(t_, end_time(), {std::min(next_step_, longest), transient_.smallest_step, longest},
                                   [&](double t, double dt) { return attempt(t, dt); });
  record_.n_cuts += report.cuts;
  next_step_ = report.wanted;
  if (!report.finished) {
    save();
    throw SolverStopped(fmt::format("the solver stopped at t = {:.5f} s: {}; partial results are kept; try --mesh 2, a "
                                    "smaller model.step_ms, or --resume",
                                    report.reached, report.reason));
  }
  if (near_rim_ && !touching() && surface_gap() > parting_gap && closing_speed() < 0) part();
}

/// Where the slider turns round its friction does, and a step takes it as it is at the step's end: by up to a step's
/// length too early, an impulse of 2 mu N dt. So steps shrink with the time to (and since) the turn; a slider that
/// hardly accelerates has none.
double StackDynamic::longest_at_turn() const {
  constexpr double at_rest = 0.3, share = 0.7; // [m/s^2]; of that time
  const double speed = active().top_of(state_.v).head<2>().norm(), rate = active().top_of(state_.a).head<2>().norm();
  return rate > at_rest ? std::max(turning_step, share * speed / rate) : longest_sliding_step;
}

bool StackDynamic::rests() const {
  const bool scout_rests = t_ < plan_.moves_from || (plan_.rests_from > 0 && t_ > plan_.rests_from);
  return scout_rests && active().top_of(state_.v).head<2>().norm() < sliding_speed;
}

double StackDynamic::clipped(double dt) const {
  constexpr double sliver = 1e-6; // [s]
  if (const double left = plan_.moves_from - t_; resting_ && left > sliver && dt > left + sliver) return left;
  if (const double longest = longest_at_turn(); !near_rim_ && !resting_ && dt > 1.001 * longest) return longest;
  const double closing = closing_speed();
  if (closing <= 0 || touching()) return 0;
  const double left = near_rim_ ? surface_gap() : gap() - 0.9 * joining_gap, until = left / closing;
  if (until >= dt) return 0;
  if (!near_rim_) return until > 1e-4 * dt ? until : 0;
  if (until > transient_.contact_step) return until;
  return dt > 1.001 * transient_.contact_step ? transient_.contact_step : 0;
}

Attempt StackDynamic::attempt(double t, double dt) {
  if (is_interrupted(options_)) {
    next_step_ = dt;
    save();
    throw Interrupted();
  }
  if (const double shorter = clipped(dt); shorter > 0)
    return {false, shorter, "the walls are about to touch, or the slider to turn round"};
  closing_before_ = closing_speed();
  Attempt result = checked_step(
      active(), state_, t, dt, [this](double at) { return load(at); }, transient_, report_,
      [&](double, const SystemState &, const ContactStepReport &step) { after_step(t + dt, dt, step); });
  if (result.accepted && near_rim_)
    result.last = !touching() && surface_gap() > parting_gap && closing_speed() < 0;
  else if (result.accepted)
    result.last = (gap() < joining_gap && closing_speed() > 0) || rests() != resting_;
  if (result.accepted && !result.last && record_.n_steps - steps_kept_ >= checkpoint_every) {
    next_step_ = result.wish;
    active().start_afresh_at(state_); // as the run that reads it will
    save();
    steps_kept_ = record_.n_steps;
  }
  return result;
}

void StackDynamic::after_step(double t, double dt, const ContactStepReport &step) {
  t_ = t;
  ++record_.n_steps;
  record_.augmentation_caps += step.capped;
  account();
  follow_impact(t, dt);
  const StackForces forces = forces_of(model_, state_);
  recorder_.sample(t, travel(), active().top_of(state_.v), state_, step.iterations, dt);
  if (near_rim_ && touching() && fields_due(t, dt, options_)) write_fields();
  if (options_.progress)
    options_.progress({t, end_time(), dt, step.iterations, gap(), forces.rim.head<2>().norm(),
                       touching()  ? "contact"
                       : near_rim_ ? "near the rim"
                                   : "sliding"});
}

void StackDynamic::write_fields() {
  fe::write_fields(active(), state_, displacements(), "stack", t_, options_, record_);
}

std::map<std::string, double> StackDynamic::time_split() const {
  auto result = alone_.time_split;
  for (const auto &[name, seconds] : joined_.time_split) result[name] += seconds;
  return result;
}

SolverWork StackDynamic::work() const {
  SolverWork result = alone_.work;
  return result += joined_.work;
}

void run_stack_dynamic(const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options,
                       RunRecord &record) {
  planning::Plan now = plan;
  std::optional<Checkpoint> kept;
  if (options.resume) kept = kept_checkpoint(options, record);
  if (kept) now.sectors = kept->field("sectors", Limits{-7, 7}); // it may have been replanned
  if (kept && (now.sectors.empty() || now.sectors.size() > 100)) kept->damaged("field sectors names no sectors");
  auto dynamic = std::make_unique<StackDynamic>(scene, now, options, record);
  std::map<std::string, double> before; // of those replanned
  SolverWork work_before;
  const auto times = [&] {
    auto result = before;
    for (const auto &[name, seconds] : dynamic->time_split()) result[name] += seconds;
    return result;
  };
  const auto work = [&] {
    SolverWork result = work_before;
    return result += dynamic->work();
  };
  run_counted(
      record,
      [&] {
        if (kept)
          dynamic->restore(*kept);
        else
          dynamic->start();
        kept.reset();
        while (const auto direction = dynamic->run()) {
          now.sectors.push_back(*direction);
          auto next = std::make_unique<StackDynamic>(scene, now, options, record);
          next->take_over(*dynamic);
          before = times();
          work_before = work();
          dynamic = std::move(next);
        }
      },
      times, work);
}

} // namespace rimpact::fe

#include "fe_contact/drive/sliding_run.h"

#include "fe_contact/drive/fields.h"
#include "fe_contact/drive/forces.h"
#include "fe_contact/drive/ground_step.h"
#include "fe_contact/drive/record_checkpoint.h"
#include "fe_contact/drive/start_on_dish.h"
#include "fe_contact/drive/state_fields.h"
#include "io/files/error.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>

namespace rimpact::fe {
namespace {

constexpr double turning_step = 1e-4; // the slider turns round in steps of this [s]
constexpr double joining_gap = 2e-3;  // the rim's solids join here [m]
constexpr double parting_gap = 1e-3;  // and leave here, the walls moving apart [m]
constexpr int steps_a_checkpoint = 25;
// A step's unaccounted energy over the largest; while it slides, what rings is the weight on the stack.
constexpr double impact_energy_tolerance = 2e-5, sliding_energy_tolerance = 1e-4;

} // namespace

SlidingRun::SlidingRun(const Rung &rung, const scene::Scene &scene, const planning::Plan &plan,
                       const RunOptions &options, RunRecord &record)
    : Drive(options, record, steps_a_checkpoint), scene_(scene), plan_(plan),
      model_(rung, scene.bearing, mesh_order(scene, plan), model_options(scene)),
      alone_(model_, scene.load.mass, RimState::held), joined_(model_, scene.load.mass, RimState::solid),
      ground_(scene.excitation, scene.load.gravity) {
  motion_.step = step_options(rung, scene, plan);
  motion_.contact_step = 0.1 * plan.step_in_contact;
  motion_.smallest_step = 1e-3 * plan.step_in_contact;
  motion_.gain_tolerance = 5e-4; // single steps at release give some back
  record.n_dofs = joined_.equations().n;
}

std::optional<double> SlidingRun::run() {
  if (record_.ended) return {};
  while (t_ < end_time() - 1e-12) {
    if (!near_rim_ && gap() < joining_gap && closing_speed() > 0) {
      if (const auto direction = unmeshed_direction()) return direction;
      join();
    }
    march_on();
  }
  write_fields();
  if (near_rim_ && impact_.touched()) record_.impacts.push_back(impact_.impact());
  record_.ended = true;
  save();
  return {};
}

void SlidingRun::start() {
  const StartOnDish start(scene_, plan_, options_, active(), motion_.step);
  const bool window = scene_.excitation.kind == scene::ExcitationKind::window;
  std::tie(state_, rest_height_) = window ? start.near_the_rim() : start.at_rest();
  rest_elastic_ = model_.share() * state_.energies.elastic;
  rest_plastic_ = model_.share() * state_.energies.plastic; // yielded on the way out
  height_before_ = travel().z();
  const double share = model_.share(), kinetic = share * active().kinetic_energy(state_);
  scale_.initial = scale_.largest = kinetic + rest_elastic_ + rest_plastic_;
  record_.ledger.initial = record_.ledger.kinetic = record_.ledger.largest_input = kinetic;
  next_step_ = motion_.smallest_step;
  sample(0, 0);
  write_fields();
  save();
}

Eigen::VectorXd SlidingRun::load(double t) const {
  const BearingSystem &system = active();
  return system.dead_load(scene_.load.vertical) + system.gravity(-ground_.acceleration(t));
}

/// One phase: the stack sliding, at rest, or with the rim.
void SlidingRun::march_on() {
  resting_ = rests_at(t_);
  motion_.step.rho_inf =
      resting_ ? 0 : scene_.model.rho_inf; // what rings on, of springs without damping, is of no interest
  motion_.step.smooth = !near_rim_;
  if (resting_) // it moves with the ground, and the load's answer is exact: the long steps need no better one
    motion_.ground = nullptr;
  else
    motion_.ground = [this](double t, double dt) { return ground_step(ground_, t, dt); };
  motion_.energy_tolerance = near_rim_ ? impact_energy_tolerance : sliding_energy_tolerance;
  const double longest = near_rim_  ? plan_.step_in_contact
                         : resting_ ? planning::longest_resting_step
                                    : longest_sliding_step;
  const MarchReport report =
      stretch_to(t_, end_time(), {std::min(next_step_, longest), motion_.smallest_step, longest});
  next_step_ = report.wanted;
  if (!report.finished) {
    save();
    throw SolverStopped(fmt::format("the solver stopped at t = {:.5f} s: {}; partial results are kept; try --mesh 2, a "
                                    "smaller model.step_ms, or --resume",
                                    report.reached, report.reason));
  }
  if (near_rim_ && leaves()) part();
}

bool SlidingRun::leaves() const {
  return !touching() && surface_gap() > parting_gap && closing_speed() < 0;
}

/// Where the slider turns round its friction does, and a step takes it as it is at the step's end: by up to a step's
/// length too early, an impulse of 2 mu N dt. So steps shrink with the time to (and since) the turn; a slider that
/// hardly accelerates has none.
double SlidingRun::longest_at_turn() const {
  constexpr double at_rest = 0.3, share = 0.95; // [m/s^2]; of that time
  const double speed = active().top_of(state_.v).head<2>().norm(), rate = active().top_of(state_.a).head<2>().norm();
  return rate > at_rest ? std::max(turning_step, share * speed / rate) : longest_sliding_step;
}

bool SlidingRun::rests_at(double t) const {
  const bool scout_rests = t < plan_.moves_from || (plan_.rests_from > 0 && t > plan_.rests_from);
  return scout_rests && active().top_of(state_.v).head<2>().norm() < sliding_speed;
}

double SlidingRun::clipped(double t, double dt) const {
  constexpr double sliver = 1e-6; // [s]
  if (const double left = plan_.moves_from - t; resting_ && left > sliver && dt > left + sliver) return left;
  if (const double longest = longest_at_turn(); !near_rim_ && !resting_ && dt > 1.001 * longest) return longest;
  const double closing = closing_speed();
  if (closing <= 0 || touching()) return 0;
  const double left = near_rim_ ? surface_gap() : gap() - 0.9 * joining_gap, until = left / closing;
  if (until >= dt) return 0;
  if (!near_rim_) return until > 1e-4 * dt ? until : 0;
  if (until > motion_.contact_step) return until;
  return dt > 1.001 * motion_.contact_step ? motion_.contact_step : 0;
}

ContactStepReport SlidingRun::solve(double t, double dt) {
  closing_before_ = closing_speed();
  load_before_ = load(t), load_after_ = load(t + dt);
  return motion_step(active(), state_, t, dt, load_after_, motion_);
}

std::vector<Event> SlidingRun::events(const SolvedStep &step) const {
  if (near_rim_) return leaves() ? std::vector{Event::parting} : std::vector<Event>{};
  if (gap() < joining_gap && closing_speed() > 0) return {Event::joining};
  if (rests_at(step.end()) != resting_) return {Event::rest};
  return {};
}

Attempt SlidingRun::assess(const SolvedStep &step) {
  const double share = model_.share(), weight = -scene_.load.vertical * (travel().z() - height_before_);
  energies_ = energies_of(active(), state_, step.report, share);
  energies_.external = share * fe::work(load_before_, load_after_, step.before, state_) - weight;
  energies_.gravity = -weight;
  energies_.elastic += share * (rim_is_solid() ? 0 : held_.energies.elastic) - rest_elastic_;
  energies_.plastic += share * (rim_is_solid() ? 0 : held_.energies.plastic) - rest_plastic_;
  return fe::assess(step, energies_, record_.ledger, scale_, state_, motion_);
}

void SlidingRun::follow(const SolvedStep &step) {
  t_ = step.end();
  book(record_.ledger, energies_);
  height_before_ = travel().z();
  follow_impact(step);
  sample(step.report.iterations, step.dt);
  report_lift();
  if (const auto sentence = touching() ? loss_of_balance(record_.ledger, t_) : std::nullopt) {
    save();
    throw SolverStopped(*sentence);
  }
  if (near_rim_ && touching() && fields_due(t_, step.dt, options_)) write_fields();
  if (options_.progress)
    options_.progress({t_, end_time(), step.dt, step.report.iterations, gap(),
                       active().force_of(state_, Role::wall).head<2>().norm(),
                       touching()  ? Phase::contact
                       : near_rim_ ? Phase::near_rim
                                   : Phase::sliding});
}

void SlidingRun::visit(StateVisitor &v) {
  v.number("reached", t_, {0, end_time() + 1e-9});
  v.number("next_step", next_step_, {0, 1e6});
  v.flag("near_rim", near_rim_);
  if (v.reads()) state_ = active().at_rest();
  fe::visit(v, state_);
  v.number("rest_height", rest_height_);
  v.number("rest_elastic", rest_elastic_);
  v.number("rest_plastic", rest_plastic_);
  v.number("height_before", height_before_);
  v.number("scale_initial", scale_.initial);
  v.number("scale_largest", scale_.largest);
  v.part("held_rim", [&] { fe::visit(v, held_, active().expand(state_).size()); });
  v.part("impact", [&] { impact_.visit(v); });
  std::vector<double> sectors = plan_.sectors; // run_sliding has read them
  v.numbers("sectors", sectors, {-7, 7}, true);
}

void SlidingRun::sample(int iterations, double dt) {
  fe::sample(record_, active(), state_,
             {t_, travel(), active().top_of(state_.v), forces_of(active(), state_), gap(), iterations, dt});
}

void SlidingRun::write_fields() {
  fe::write_fields(active(), state_, displacements(), t_, options_, record_);
}

std::map<std::string, double> SlidingRun::time_split() const {
  auto result = alone_.time_split;
  for (const auto &[name, seconds] : joined_.time_split) result[name] += seconds;
  return result;
}

SolverWork SlidingRun::work() const {
  SolverWork result = alone_.work;
  return result += joined_.work;
}

void run_sliding(const Rung &rung, const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options,
                 RunRecord &record) {
  planning::Plan now = plan;
  std::optional<Checkpoint> kept;
  if (options.resume) kept = kept_checkpoint(options, record);
  if (kept) now.sectors = kept->field("sectors", Limits{-7, 7}); // it may have been replanned
  if (kept && (now.sectors.empty() || now.sectors.size() > 100)) kept->damaged("field sectors names no sectors");
  auto dynamic = std::make_unique<SlidingRun>(rung, scene, now, options, record);
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
          auto next = std::make_unique<SlidingRun>(rung, scene, now, options, record);
          next->take_over(*dynamic);
          before = times();
          work_before = work();
          dynamic = std::move(next);
        }
      },
      times, work, [&] { return dynamic->steel(); });
}

} // namespace rimpact::fe

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
#include <tuple>

namespace rimpact::fe {
namespace {

constexpr double parting_gap = 1e-3; // the rim's solids leave here, the walls moving apart [m]
// A step's unaccounted energy over the largest; while it slides, what rings is the weight on the stack.
constexpr double impact_energy_tolerance = 2e-5, sliding_energy_tolerance = 1e-4;

} // namespace

SlidingRun::SlidingRun(const Rung &rung, const scene::Scene &scene, const planning::Plan &plan,
                       const RunOptions &options, RunRecord &record)
    : Drive(options, record), scene_(scene), plan_(plan), stack_(rung, scene, plan_),
      ground_(scene.excitation, scene.load.gravity), pace_(plan_, 0.1 * plan.step_in_contact) {
  motion_.step = step_options(rung, scene, plan);
  motion_.contact_step = 0.1 * plan.step_in_contact;
  motion_.smallest_step = 1e-3 * plan.step_in_contact;
  motion_.gain_tolerance = 5e-4; // single steps at release give some back
  record.n_dofs = stack_.unknowns();
}

std::optional<double> SlidingRun::run() {
  if (record_.ended) return {};
  while (t_ < end_time() - 1e-12) {
    if (!stack_.near_rim && stack_.gap() < joining_gap && stack_.closing_speed() > 0) {
      if (const auto direction = unmeshed_direction()) return direction;
      stack_.join();
      impact_.forget();
    }
    march_on();
  }
  write_fields();
  if (stack_.near_rim && impact_.touched()) record_.impacts.push_back(impact_.impact());
  record_.ended = true;
  save();
  return {};
}

void SlidingRun::start() {
  const StartOnDish start(scene_, plan_, options_, stack_.active(), motion_.step);
  const bool window = scene_.excitation.kind == scene::ExcitationKind::window;
  std::tie(stack_.state, stack_.rest_height) = window ? start.near_the_rim() : start.at_rest();
  stack_.rest_elastic = stack_.model().energy_share() * stack_.state.energies.elastic;
  stack_.rest_plastic = stack_.model().energy_share() * stack_.state.energies.plastic; // yielded on the way out
  height_before_ = stack_.travel().z();
  const double kinetic = stack_.kinetic_energy();
  scale_.initial = scale_.largest = kinetic + stack_.rest_elastic + stack_.rest_plastic;
  record_.ledger.initial = record_.ledger.kinetic = record_.ledger.largest_input = kinetic;
  next_step_ = motion_.smallest_step;
  sample(0, 0);
  write_fields();
  save();
}

Eigen::VectorXd SlidingRun::load(double t) const {
  const BearingSystem &system = stack_.active();
  return system.dead_load(scene_.load.vertical) + system.gravity(-ground_.acceleration(t) / stack_.model().rate_ratio);
}

/// One phase: the stack sliding, at rest, or with the rim.
void SlidingRun::march_on() {
  resting_ = pace_.rests_at(t_, stack_);
  motion_.step.rho_inf =
      resting_ ? 0 : scene_.model.rho_inf; // what rings on, of springs without damping, is of no interest
  motion_.step.smooth = !stack_.near_rim;
  if (resting_) // it moves with the ground, and the load's answer is exact: the long steps need no better one
    motion_.ground = nullptr;
  else
    motion_.ground = [this](double t, double dt) { return ground_step(ground_, t, dt) / stack_.model().rate_ratio; };
  motion_.energy_tolerance = stack_.near_rim ? impact_energy_tolerance : sliding_energy_tolerance;
  const double longest = pace_.longest(stack_, resting_);
  const MarchReport report =
      stretch_to(t_, end_time(), {std::min(next_step_, longest), motion_.smallest_step, longest});
  next_step_ = report.wanted;
  if (!report.finished) {
    save();
    throw SolverStopped(fmt::format("the solver stopped at t = {:.5f} s: {}; partial results are kept; try --mesh 2, a "
                                    "smaller model.step_ms, or --resume",
                                    report.reached, report.reason));
  }
  if (stack_.near_rim && leaves()) part();
}

bool SlidingRun::leaves() const {
  return !stack_.touching() && surface_gap() > parting_gap && stack_.closing_speed() < 0;
}

ContactStepReport SlidingRun::solve(double t, double dt) {
  closing_before_ = stack_.closing_speed();
  load_before_ = load(t), load_after_ = load(t + dt);
  return motion_step(stack_.active(), stack_.state, t, dt, load_after_, motion_);
}

std::vector<Event> SlidingRun::events(const SolvedStep &step) const {
  if (stack_.near_rim) return leaves() ? std::vector{Event::parting} : std::vector<Event>{};
  if (stack_.gap() < joining_gap && stack_.closing_speed() > 0) return {Event::joining};
  if (pace_.rests_at(step.end(), stack_) != resting_) return {Event::rest};
  return {};
}

Attempt SlidingRun::assess(const SolvedStep &step) {
  const double share = stack_.model().energy_share(),
               weight = -scene_.load.vertical * (stack_.travel().z() - height_before_);
  energies_ = energies_of(stack_.active(), stack_.state, step.report, share);
  energies_.external = share * fe::work(load_before_, load_after_, step.before, stack_.state) - weight;
  energies_.gravity = -weight;
  energies_.elastic += share * (stack_.rim_is_solid() ? 0 : stack_.held.energies.elastic) - stack_.rest_elastic;
  energies_.plastic += share * (stack_.rim_is_solid() ? 0 : stack_.held.energies.plastic) - stack_.rest_plastic;
  return fe::assess(step, energies_, record_.ledger, scale_, stack_.state, motion_);
}

void SlidingRun::follow(const SolvedStep &step) {
  t_ = step.end();
  book(record_.ledger, energies_);
  height_before_ = stack_.travel().z();
  follow_impact(step);
  sample(step.report.iterations, step.dt);
  report_lift();
  if (stack_.touching()) stop_for(loss_of_balance(record_.ledger, t_));
  stop_for(stop_of_halves(stack_.active(), stack_.state, fmt::format("t = {:.4f} s", t_)));
  if (stack_.near_rim && stack_.touching() && fields_due(t_, step.dt, options_)) write_fields();
  if (options_.progress)
    options_.progress({t_, end_time(), step.dt, step.report.iterations, stack_.gap(),
                       stack_.active().force_of(stack_.state, Role::wall).head<2>().norm(),
                       stack_.touching() ? Phase::contact
                       : stack_.near_rim ? Phase::near_rim
                                         : Phase::sliding});
}

void SlidingRun::visit(StateVisitor &v) {
  v.number("reached", t_, {0, end_time() + 1e-9});
  v.number("next_step", next_step_, {0, 1e6});
  v.flag("near_rim", stack_.near_rim);
  if (v.reads()) stack_.state = stack_.active().at_rest();
  fe::visit(v, stack_.state);
  v.number("rest_height", stack_.rest_height);
  v.number("rest_elastic", stack_.rest_elastic);
  v.number("rest_plastic", stack_.rest_plastic);
  v.number("height_before", height_before_);
  v.number("scale_initial", scale_.initial);
  v.number("scale_largest", scale_.largest);
  v.part("held_rim", [&] { fe::visit(v, stack_.held, stack_.active().expand(stack_.state).size()); });
  v.part("impact", [&] { impact_.visit(v); });
  std::vector<double> sectors = plan_.sectors; // run_sliding has read them
  v.numbers("sectors", sectors, {-7, 7}, true);
}

void SlidingRun::sample(int iterations, double dt) {
  fe::sample(
      record_, stack_.active(), stack_.state,
      {t_, stack_.travel(), stack_.velocity(), forces_of(stack_.active(), stack_.state), stack_.gap(), iterations, dt});
}

void SlidingRun::write_fields() {
  fe::write_fields(stack_.active(), stack_.state, stack_.displacements(), t_, options_, record_);
}

double SlidingRun::surface_gap() const {
  return impact_.touched() ? stack_.active().wall_distance(stack_.state, stack_.gap()) : stack_.gap();
}

void SlidingRun::part() {
  if (impact_.touched()) {
    record_.impacts.push_back(impact_.impact());
    write_fields();
  }
  next_step_ = motion_.contact_step;
  const double lost = stack_.part(); // the rim still rang
  impact_.forget();
  if (stack_.all_solid()) return;
  record_.ledger.impact += lost;
  record_.ledger.kinetic = stack_.kinetic_energy();
}

void SlidingRun::follow_impact(const SolvedStep &step) {
  const double force = stack_.active().force_of(stack_.state, Role::wall).head<2>().norm();
  if (force <= 0) return;
  if (!impact_.touched()) impact_.begin(step.t, {stack_.ridden().x(), stack_.ridden().y(), 0}, closing_before_);
  impact_.touch();
  impact_.follow(t_, force, -stack_.gap(), stack_.closing_speed());
  if (impact_.turns(stack_.closing_speed())) write_fields();
}

/// Once, at the first instant without a normal force: the landings that follow are most of the run.
void SlidingRun::report_lift() {
  constexpr double worth_it = 0.5; // left of the scene [s]
  if (reported_lift_ || !options_.remark || forces_of(stack_.active(), stack_.state).normal > 0 ||
      end_time() - t_ < worth_it)
    return;
  reported_lift_ = true;
  const bool damped = stack_.model().options.pad_retardation > 0, has_pad = stack_.model().bearing.has_pad();
  options_.remark(fmt::format(
      "the slider leaves the dish at t = {:.3f} of {:g} s: it lands again every tenth of a second or so{}, and each "
      "landing takes about a hundred iterations; a shorter excitation.duration_s{} ends the run sooner",
      t_, end_time(), damped ? "" : ", undamped",
      damped || !has_pad ? "" : ", or a loss of the pad (bearing.pad.loss_factor),"));
}

std::optional<double> SlidingRun::unmeshed_direction() {
  constexpr double served = 0.15; // cells grow away from a sector's middle [rad]
  const Eigen::Vector2d u = stack_.ridden();
  const double direction = std::atan2(u.y(), u.x()),
               reach = scene_.model.own_mesh.any() ? plan_.sector_half_angle - 0.3 : served;
  const auto serves = [&](double sector) { return std::abs(std::remainder(direction - sector, 2 * M_PI)) < reach; };
  if (std::any_of(plan_.sectors.begin(), plan_.sectors.end(), serves)) return {};
  if (!scene_.model.own_mesh.any()) return stack_.model().mesh.half ? (u.x() < 0 ? M_PI : 0.0) : direction;
  save();
  throw SolverStopped(
      fmt::format("at t = {:.4f} s the slider comes to the rim at {:.0f} deg, where the scout saw no impact and the "
                  "own mesh is not known to "
                  "have a rim; partial results are kept; without an own mesh the run would replan itself",
                  t_, direction * 180 / M_PI));
}

void SlidingRun::take_over(const SlidingRun &old) {
  stack_.carry_over(old.stack_);
  stack_.balance(load(old.t_), motion_.step);
  t_ = old.t_;
  scale_ = old.scale_, height_before_ = stack_.travel().z();
  next_step_ = motion_.contact_step;
  const double lost = book_hand_over(old);
  record_.n_dofs = stack_.unknowns();
  record_.warnings.push_back(fmt::format(
      "at {:.3f} s the slider came to the rim at {:.0f} deg, where the scout saw no impact: replanned, from there on "
      "with "
      "{} sectors and {} unknowns; the hand-over to the new mesh changed the energy by {:.1e} of the largest input",
      t_, plan_.sectors.back() * 180 / M_PI, plan_.sectors.size(), record_.n_dofs,
      lost / std::max(record_.ledger.largest_input, 1e-300)));
  save();
}

/// What the new mesh stores less than the old one is the numerics' loss. Returns its amount [J].
double SlidingRun::book_hand_over(const SlidingRun &old) {
  EnergyLedger &ledger = record_.ledger;
  const EnergyLedger before = ledger;
  const double share = stack_.model().energy_share(),
               sunk = scene_.load.vertical * (old.height_before_ - height_before_);
  ledger.kinetic = stack_.kinetic_energy();
  ledger.elastic = share * (stack_.state.energies.elastic + stack_.held.energies.elastic) - stack_.rest_elastic;
  ledger.plastic = share * (stack_.state.energies.plastic + stack_.held.energies.plastic) - stack_.rest_plastic;
  ledger.damping = share * stack_.state.energies.damping;
  const double lost = before.kinetic - ledger.kinetic + before.elastic - ledger.elastic + before.plastic -
                      ledger.plastic + before.damping - ledger.damping + sunk;
  ledger.integrator += lost;
  ledger.gravity -= sunk;
  return std::abs(lost);
}

} // namespace rimpact::fe

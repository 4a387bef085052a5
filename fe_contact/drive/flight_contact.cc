// A dynamic run of rung rim while slider and rim touch: from the first overlap to the parts at rest after the release.
#include "fe_contact/drive/fields.h"
#include "fe_contact/drive/flight_run.h"
#include "fe_contact/drive/step_control.h"
#include "fe_contact/engine/solid_fields.h"

#include "io/files/error.h"
#include "responses/open_impact.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::fe {
namespace {

constexpr double first_overlap = 1e-5;   ///< the first step moves the slider by this [m]
constexpr double smallest_pull = 1e-3;   ///< of the dish on the mass, over m g: lifted off beyond it
constexpr double deepest_landing = 1e-6; ///< the mass is back on the dish when it has sunk by this [m]
constexpr double finest = 1.0 / 32;      ///< of the longest step: a step so short is taken, and holds any event sharply

} // namespace

MassForces FlightRun::forces_now(double t, double multiplier) const {
  return loads_.forces(arc().frame.displacement(top()), arc().frame.rate(top_speed()), t, support_, multiplier);
}

void FlightRun::begin_contact() {
  SystemState &state = arc().state;
  const RimFrame &frame = arc().frame;
  lift_height_ = 0;
  if (support_ != Support::held) support_ = bearing_.airborne ? Support::airborne : Support::dish;
  const auto reduced = model_.forces(bearing_);
  multiplier_ = support_ == Support::dish
                    ? reduced.normal / std::hypot(1.0, model_.height(bearing_.u.x(), bearing_.u.y()).gradient.norm())
                    : 0;
  const MassForces now = loads_.forces(bearing_.u, bearing_.v, bearing_.t, support_, multiplier_);
  Eigen::Vector3d acceleration = now.total() / scene_.load.mass;
  if (support_ == Support::held) acceleration.z() = 0;
  state.v.setZero();
  state.a.setZero();
  system_.set_position(state, frame.master(bearing_.u), frame.master_rate(bearing_.v), frame.master_rate(acceleration));
  state.R.setZero(); // the parts are at rest in themselves
  const Eigen::Vector3d on_top = frame.master_force(now.total());
  for (int i = 0; i < 3; ++i)
    if (const int equation = system_.top().equation[i]; equation >= 0)
      state.R[equation] = on_top[i] / system_.model().share();
  const double approach_speed = radial_speed();
  impact_.begin(bearing_.t, bearing_.u, approach_speed);
  others_elastic_ = record_.ledger.elastic - system_.model().energy_share() * state.energies.elastic;
  others_plastic_ = record_.ledger.plastic - system_.model().energy_share() * state.energies.plastic;
  next_step_ = std::min(0.25 * plan_.step_in_contact, first_overlap / std::max(1e-3, approach_speed));
  in_contact_ = true;
  if (record_.response.size() == 0) sample(0, now, 0); // a window starts here
}

void FlightRun::contact() {
  if (!in_contact_) {
    choose_arc();
    begin_contact();
  }
  const double longest = plan_.step_in_contact, smallest = smallest_step();
  const MarchReport report = stretch_to(bearing_.t, end_time(), {next_step_, smallest, longest});
  if (report.finished) return;
  next_step_ = smallest;
  save();
  throw SolverStopped(fmt::format(
      "the solver stopped at t = {:.6f} s, in contact, with a step of {:.3g} us: {}; partial results are kept; try "
      "--set model.mesh=2 or a smaller model.step_ms and --resume",
      report.reached, 1e6 * smallest, report.reason));
}

ContactStepReport FlightRun::solve(double t, double dt) {
  forces_before_ = forces_now(t, multiplier_);
  StepTerms terms{Eigen::VectorXd::Zero(system_.equations().n)};
  terms.dt = dt;
  const RemoteTerms remote{system_.top(), loads_.law(arc().frame, t + dt, support_), system_.model().share(),
                           multiplier_};
  terms.remote = &remote;
  StepOptions options = step_options_;
  if (dt > 1.001 * smallest_step()) options.newton.patience = patience_of_newton;
  ContactStepReport report = time_step(system_, arc().state, terms, options);
  if (report.converged) forces_after_ = forces_now(t + dt, report.multiplier);
  return report;
}

std::vector<Event> FlightRun::events(const SolvedStep &step) const {
  std::vector<Event> result;
  // The dish is held by its speed (see RemoteLoad), so that heights drift by microns: those since the lift-off count.
  if (support_ == Support::dish && step.report.multiplier < -smallest_pull * scene_.load.mass * scene_.load.gravity)
    result.push_back(Event::lift_off);
  else if (support_ == Support::airborne && height_above_dish() < lift_height_ - deepest_landing)
    result.push_back(Event::landing);
  if (system_.walls_touch(arc().state)) return result;
  if (impact_.touched())
    result.push_back(Event::release);
  else if (top_speed().x() < 0)
    result.push_back(Event::miss);
  return result;
}

double FlightRun::sharp_step(const std::vector<Event> &events) const {
  const bool any = std::ranges::any_of(events, [](Event event) { return event != Event::miss; });
  return any ? finest * plan_.step_in_contact : 0;
}

FlightStep FlightRun::flight_step(const SolvedStep &step) const {
  return {system_, arc().frame, step.before, arc().state, forces_before_, forces_after_};
}

Attempt FlightRun::assess(const SolvedStep &step) {
  constexpr double displacement_tolerance = 2e-6; // [m] a step
  constexpr double energy_tolerance = 1.5e-5;     // of the largest input, a step
  constexpr StepControl control{.most_error = 4, .least_cut = 0.25, .most_growth = 1.6, .most_of_a_jump = 20};
  const FlightStep flight = flight_step(step);
  energies_ = flight.energies(step.report);
  energies_.elastic += others_elastic_;
  energies_.plastic += others_plastic_;
  const double displacement = flight.displacement_error(scene_.model.rho_inf, step.dt) / displacement_tolerance;
  const double energy = std::abs(energies_.unbalanced(record_.ledger) + flight.work_of_dish()) /
                        (energy_tolerance * std::max(1.0, record_.ledger.largest_input));
  return control.assess(std::max(displacement, energy), step.dt, step.dt > finest * plan_.step_in_contact,
                        arc().state.growth_hold > 0, step.before.refused_error);
}

void FlightRun::follow(const SolvedStep &step) {
  bearing_.t = step.end();
  multiplier_ = step.report.multiplier;
  book(record_.ledger, energies_);
  bearing_.u = arc().frame.displacement(top());
  bearing_.v = arc().frame.rate(top_speed());
  sample(step.report.iterations, forces_after_, step.dt);
  const double force = wall_force();
  impact_.follow(bearing_.t, force, penetration(), top_speed().x());
  picture(bearing_.t, step.dt);
  if (options_.progress)
    options_.progress({bearing_.t, end_time(), step.dt, step.report.iterations, -penetration(), force, Phase::contact});
  if (system_.walls_touch(arc().state)) impact_.touch();
  refuse_passage();
  if (const auto sentence = impact_.touched() ? loss_of_balance(record_.ledger, bearing_.t) : std::nullopt)
    stop_impact(*sentence);
}

void FlightRun::picture(double t, double dt) {
  if (impact_.turns(top_speed().x()) || (impact_.touched() && fields_due(t, dt, options_))) write_fields();
}

bool FlightRun::take(const std::vector<Event> &events) {
  bool ended = false;
  for (const Event event : events) {
    if (event == Event::lift_off) {
      support_ = Support::airborne;
      multiplier_ = 0;
      lift_height_ = std::min(0.0, height_above_dish());
    } else if (event == Event::landing) {
      land();
    } else {
      end_contact();
      ended = true;
    }
  }
  return ended;
}

void FlightRun::refuse_passage() {
  const Passage passage{.depth = penetration() / arc().frame.dishes,
                        .outward_speed = radial_speed(),
                        .approach_speed = impact_.impact().approach_speed,
                        .let_go = impact_.touched() && !system_.walls_touch(arc().state),
                        .may_touch = !window()};
  const auto sentence = passes(scene_.bearing.rim, passage, bearing_.t);
  if (sentence) stop_impact(*sentence);
}

void FlightRun::stop_impact(const std::string &reason) {
  save();
  record_.impacts.push_back(left_open(impact_.impact())); // the force may be nil now, so the response does not tell
  throw SolverStopped(reason);
}

double FlightRun::height_above_dish() const {
  return loads_.height_above_dish(arc().frame.displacement(top()));
}

void FlightRun::land() {
  const Eigen::Vector3d n = loads_.normal(bearing_.u);
  const double approach = bearing_.v.dot(n);
  support_ = Support::dish;
  if (approach >= 0) return;
  const double before = record_.ledger.kinetic;
  system_.apply_velocity_jump(arc().state,
                              arc().frame.master_rate(-(1 + scene_.reduced.vertical_restitution) * approach * n));
  record_.ledger.kinetic = system_.model().energy_share() * system_.kinetic_energy(arc().state);
  record_.ledger.contact += before - record_.ledger.kinetic;
  bearing_.v = arc().frame.rate(top_speed());
}

void FlightRun::end_contact() {
  impact_.set_rebound(-radial_speed());
  const double share = system_.model().energy_share();
  SystemState &state = arc().state;
  const double strained = share * (state.energies.elastic + state.energies.plastic);
  const Eigen::Vector3d speed = top_speed();
  const double moving = share * system_.kinetic_energy(state) - system_.rigid_kinetic_energy(speed);
  const ContactStepReport report = system_.relax(state, step_options_);
  if (!report.converged) throw SolverStopped("the parts did not come to rest after the release: " + report.reason);
  record_.ledger.elastic = others_elastic_ + share * state.energies.elastic;
  record_.ledger.plastic = others_plastic_ + share * state.energies.plastic;
  record_.ledger.impact += moving + strained - share * (state.energies.elastic + state.energies.plastic);
  record_.ledger.kinetic = system_.rigid_kinetic_energy(speed);
  arc().yielded = largest_plastic_strain(state.history) > 0;
  bearing_.airborne = support_ == Support::airborne;
  const double dish = model_.height(bearing_.u.x(), bearing_.u.y()).z; // the height may have drifted by microns
  if (support_ != Support::held) bearing_.u.z() = support_ == Support::dish ? dish : std::max(dish, bearing_.u.z());
  if (impact_.touched()) {
    record_.impacts.push_back(impact_.impact());
    write_fields();
  }
  in_contact_ = false;
  save();
}

} // namespace rimpact::fe

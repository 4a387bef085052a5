#include "fe_contact/drive/arc_contact.h"

#include "fe_contact/engine/solid_fields.h"
#include "io/files/error.h"
#include <algorithm>
#include <cmath>

namespace rimpact::fe {
namespace {

constexpr double first_overlap = 1e-5;   ///< the first step moves the slider by this [m]
constexpr double smallest_pull = 1e-3;   ///< of the dish on the mass, over m g: lifted off beyond it
constexpr double deepest_landing = 1e-6; ///< the mass is back on the dish when it has sunk by this [m]
constexpr double finest = 1.0 / 32;      ///< of the longest step: a step so short is taken, and holds any event sharply

} // namespace

ArcContact::ArcContact(const scene::Scene &scene, const planning::Plan &plan, BearingSystem &system, TouchedArcs &arcs,
                       const reduced::PhysicalModel &model)
    : scene_(scene), plan_(plan), system_(system), arcs_(arcs), model_(model),
      step_options_(step_options(system.model().rung, scene, plan)), loads_(scene, model),
      support_(loads_.initial_support()) {}

double ArcContact::finest_step() const {
  return finest * plan_.step_in_contact;
}

double ArcContact::first_step(double approach_speed) const {
  return std::min(0.25 * plan_.step_in_contact, first_overlap / std::max(1e-3, approach_speed));
}

MassForces ArcContact::begin(const reduced::BearingState &bearing, const EnergyLedger &ledger) {
  SystemState &state = arc().state;
  const RimFrame &frame = arc().frame;
  lift_height_ = 0;
  if (support_ != Support::held) support_ = bearing.airborne ? Support::airborne : Support::dish;
  const auto reduced = model_.forces(bearing);
  multiplier_ = support_ == Support::dish
                    ? reduced.normal / std::hypot(1.0, model_.height(bearing.u.x(), bearing.u.y()).gradient.norm())
                    : 0;
  const MassForces now = loads_.forces(bearing.u, bearing.v, bearing.t, support_, multiplier_);
  Eigen::Vector3d acceleration = now.total() / scene_.load.mass;
  if (support_ == Support::held) acceleration.z() = 0;
  state.v.setZero();
  state.a.setZero();
  system_.set_position(state, frame.master(bearing.u), frame.master_rate(bearing.v), frame.master_rate(acceleration));
  state.R.setZero(); // the parts are at rest in themselves
  const Eigen::Vector3d on_top = frame.master_force(now.total());
  for (int i = 0; i < 3; ++i)
    if (const int equation = system_.top().equation[i]; equation >= 0)
      state.R[equation] = on_top[i] / system_.model().share();
  others_elastic_ = ledger.elastic - system_.model().energy_share() * state.energies.elastic;
  others_plastic_ = ledger.plastic - system_.model().energy_share() * state.energies.plastic;
  return now;
}

ContactStepReport ArcContact::solve(double t, double dt) {
  forces_before_ = forces_at(t, multiplier_);
  StepTerms terms{Eigen::VectorXd::Zero(system_.equations().n)};
  terms.dt = dt;
  const RemoteTerms remote{system_.top(), loads_.law(arc().frame, t + dt, support_), system_.model().share(),
                           multiplier_};
  terms.remote = &remote;
  StepOptions options = step_options_;
  if (dt > 1.001 * smallest_step()) options.newton.patience = patience_of_newton;
  ContactStepReport report = time_step(system_, arc().state, terms, options);
  if (report.converged) forces_after_ = forces_at(t + dt, report.multiplier);
  return report;
}

std::vector<Event> ArcContact::events(const SolvedStep &step, bool touched) const {
  std::vector<Event> result;
  // The dish is held by its speed (see RemoteLoad), so that heights drift by microns: those since the lift-off count.
  if (support_ == Support::dish && step.report.multiplier < -smallest_pull * scene_.load.mass * scene_.load.gravity)
    result.push_back(Event::lift_off);
  else if (support_ == Support::airborne && height_above_dish() < lift_height_ - deepest_landing)
    result.push_back(Event::landing);
  if (walls_touch()) return result;
  if (touched)
    result.push_back(Event::release);
  else if (outward_speed() < 0)
    result.push_back(Event::miss);
  return result;
}

Attempt ArcContact::assess(const SolvedStep &step, const EnergyLedger &ledger) {
  constexpr double displacement_tolerance = 2e-6; // [m] a step
  constexpr double energy_tolerance = 1.5e-5;     // of the largest input, a step
  constexpr StepControl control{.most_error = 4, .least_cut = 0.25, .most_growth = 1.6, .most_of_a_jump = 20};
  const FlightStep flight{system_, arc().frame, step.before, arc().state, forces_before_, forces_after_};
  energies_ = flight.energies(step.report);
  energies_.elastic += others_elastic_;
  energies_.plastic += others_plastic_;
  const double displacement = flight.displacement_error(scene_.model.rho_inf, step.dt) / displacement_tolerance;
  const double energy = std::abs(energies_.unbalanced(ledger) + flight.work_of_dish()) /
                        (energy_tolerance * std::max(1.0, ledger.largest_input));
  return control.assess(std::max(displacement, energy), step.dt, step.dt > finest_step(), arc().state.growth_hold > 0,
                        step.before.refused_error);
}

void ArcContact::lift_off() {
  support_ = Support::airborne;
  multiplier_ = 0;
  lift_height_ = std::min(0.0, height_above_dish());
}

void ArcContact::land(EnergyLedger &ledger) {
  const Eigen::Vector3d n = loads_.normal(displacement());
  const double approach = speed().dot(n);
  support_ = Support::dish;
  if (approach >= 0) return;
  const double before = ledger.kinetic;
  system_.apply_velocity_jump(arc().state,
                              arc().frame.master_rate(-(1 + scene_.reduced.vertical_restitution) * approach * n));
  ledger.kinetic = system_.model().energy_share() * system_.kinetic_energy(arc().state);
  ledger.contact += before - ledger.kinetic;
}

void ArcContact::rest(EnergyLedger &ledger) {
  const double share = system_.model().energy_share();
  SystemState &state = arc().state;
  const double strained = share * (state.energies.elastic + state.energies.plastic);
  const Eigen::Vector3d at_release = top_speed();
  const double moving = share * system_.kinetic_energy(state) - system_.rigid_kinetic_energy(at_release);
  const ContactStepReport report = system_.relax(state, step_options_);
  if (!report.converged) throw SolverStopped("the parts did not come to rest after the release: " + report.reason);
  ledger.elastic = others_elastic_ + share * state.energies.elastic;
  ledger.plastic = others_plastic_ + share * state.energies.plastic;
  ledger.impact += moving + strained - share * (state.energies.elastic + state.energies.plastic);
  ledger.kinetic = system_.rigid_kinetic_energy(at_release);
  arc().yielded = largest_plastic_strain(state.history) > 0;
}

void ArcContact::leave(reduced::BearingState &bearing) const {
  bearing.airborne = support_ == Support::airborne;
  const double dish = model_.height(bearing.u.x(), bearing.u.y()).z; // the height may have drifted by microns
  if (support_ != Support::held) bearing.u.z() = support_ == Support::dish ? dish : std::max(dish, bearing.u.z());
}

void ArcContact::visit(StateVisitor &v) {
  v.choice("support", support_);
  v.number("multiplier", multiplier_);
  v.number("others_elastic", others_elastic_);
  v.number("others_plastic", others_plastic_);
  v.number("lift_height", lift_height_);
}

} // namespace rimpact::fe

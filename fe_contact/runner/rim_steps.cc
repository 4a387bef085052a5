// What can be done with the rim's solids: pushing, stepping in time, placing, coming to rest.
#include "fe_contact/runner/rim_trial.h"

#include "scene/error.h"

namespace rimpact::fe {

void RimSolver::commit(ArcState &state, Trial &trial) const {
  state.u = trial.u;
  state.history.swap(trial.history);
  state.contact = trial.contact;
  WallContact::augment(state.contact); // the pressure reached is the next step's multiplier
  contact_.settle_edges(equations_.expand(trial.u), state.contact);
  state.R = trial.R;
  state.energies = trial.energies;
  state.report = trial.report;
  state.master = master_of(trial.u);
}

StepReport RimSolver::push(ArcState &state, const Eigen::Vector3d &target) {
  // Evaluated anew, the points are at rest and their tangent is elastic where they are about to flow on: onwards the
  // first change is made with the tangent of the last solution. Back from the deepest point the new one is right.
  const Eigen::Vector3d to_go = target - state.master;
  const bool onwards = to_go.dot(last_push_) > 0;
  last_push_.setZero();
  Trial trial;
  trial.u = state.u;
  trial.keeps_tangent = onwards;
  StepReport report = iterate(state, trial, true, nullptr, nullptr, &target);
  if (!report.converged && onwards) {
    const int spent = report.iterations;
    trial.u = state.u;
    report = iterate(state, trial, true, nullptr, nullptr, &target);
    report.iterations += spent;
  }
  if (!report.converged) return report;
  last_push_ = to_go;
  const ContactState before = state.contact;
  commit(state, trial);
  report.contact_work = share() * contact_.work(before, state.contact);
  report.rim_force = share() * state.report.force;
  if (half_) report.rim_force.y() = 0;
  return report;
}

StepReport RimSolver::relax(ArcState &state) {
  last_push_.setZero();
  Trial trial;
  trial.u = state.u;
  const Eigen::Vector3d target = state.master;
  StepReport report = iterate(state, trial, false, nullptr, nullptr, &target);
  if (!report.converged) return report;
  commit(state, trial);
  state.contact = contact_.open();
  state.v.setZero();
  state.a.setZero();
  return report;
}

StepReport RimSolver::step(ArcState &state, double dt, const MasterLaw &law, double multiplier) {
  last_push_.setZero();
  const GeneralizedAlpha scheme = GeneralizedAlpha::from(options_.rho_inf);
  const Inertia inertia{scheme, dt, scheme.predicted_displacement(state.u, state.v, state.a, dt),
                        scheme.predicted_velocity(state.v, state.a, dt), state.a};
  Trial trial;
  // Start from the last increment repeated: loading goes on mostly as it did. Where it does not, from the old
  // state.
  const bool extrapolate = state.last_dt > 0;
  trial.u = extrapolate ? Eigen::VectorXd(state.u + dt / state.last_dt * state.last_change) : state.u;
  trial.multiplier = multiplier;
  trial.pressure_change = state.last_pressure_change;
  for (double &change : trial.pressure_change) change *= extrapolate ? dt / state.last_dt : 0;
  StepReport report = iterate(state, trial, true, &inertia, &law, nullptr);
  if (!report.converged && extrapolate) {
    const int spent = report.iterations;
    trial.u = state.u;
    trial.pressure_change.clear();
    trial.multiplier = multiplier;
    report = iterate(state, trial, true, &inertia, &law, nullptr);
    report.iterations += spent;
  }
  if (!report.converged) return report;
  state.last_dt = dt;
  state.last_change = trial.u - state.u;
  const Eigen::VectorXd a = inertia.acceleration(trial.u), change_of_a = a - state.a;
  report.integrator_loss = share() * scheme.loss(dt, trial.u - state.u, change_of_a,
                                                 mass_->multiply(change_of_a), state.R, trial.R);
  const ContactState before = state.contact;
  commit(state, trial);
  state.last_pressure_change = state.contact.pressure;
  for (std::size_t k = 0; k < before.pressure.size(); ++k) state.last_pressure_change[k] -= before.pressure[k];
  state.v = inertia.velocity(a);
  state.a = a;
  state.master_velocity = master_of(state.v);
  report.multiplier = trial.multiplier;
  report.contact_work = share() * contact_.work(before, state.contact);
  report.rim_force = share() * state.report.force;
  if (half_) report.rim_force.y() = 0;
  return report;
}

void RimSolver::place(ArcState &state, const Eigen::Vector3d &master, const Eigen::Vector3d &velocity,
                      const Eigen::Vector3d &acceleration) const {
  for (int i = 0; i < 3; ++i)
    for (const int equation : slider_equations_[i]) {
      state.u[equation] += master[i] - state.master[i];
      state.v[equation] = velocity[i];
      state.a[equation] = acceleration[i];
    }
  state.last_dt = 0;
  state.last_pressure_change.clear();
  state.master = master_of(state.u);
  state.master_velocity = master_of(state.v);
  state.contact = contact_.open();
  contact_.settle_edges(equations_.expand(state.u), state.contact);
}

void RimSolver::kick(ArcState &state, const Eigen::Vector3d &velocity) const {
  for (int i = 0; i < 3; ++i)
    for (const int equation : slider_equations_[i]) state.v[equation] += velocity[i];
  state.master_velocity = master_of(state.v);
}

void RimSolver::refresh_forces(ArcState &state, const MasterLaw &law, double multiplier) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(equations_.n);
  SolidHistory unchanged;
  state.energies = {};
  if (!solid_.assemble(equations_.expand(state.u), state.history, unchanged, equations_, forces, nullptr,
                       state.energies))
    throw SolverStopped("a stored state of the rim is not admissible");
  state.R = -forces;
  const MasterLoad load = law(state.master, state.master_velocity, multiplier);
  for (int i = 0; i < 3; ++i)
    if (master_[i] >= 0) state.R[master_[i]] += load.force[i] / share();
}

double RimSolver::surface_gap(const ArcState &state, const Eigen::Vector3d &master) const {
  ArcState moved = state;
  place(moved, master, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
  ContactState contact = contact_.open();
  contact_.settle_edges(equations_.expand(moved.u), contact);
  return contact_.assemble(equations_.expand(moved.u), contact, equations_, nullptr, nullptr).smallest_gap;
}

double RimSolver::kinetic_energy(const ArcState &state) const {
  return 0.5 * share() * state.v.dot(mass_->multiply(state.v));
}

double RimSolver::rigid_kinetic_energy(const Eigen::Vector3d &velocity) const {
  return 0.5 * options_.attached_mass * velocity.squaredNorm();
}

double RimSolver::largest_plastic_strain(const ArcState &state) const {
  double largest = 0;
  for (const auto &point : state.history) largest = std::max(largest, point.alpha);
  return largest;
}

} // namespace rimpact::fe

#include "fe_contact/runner/rim_solver.h"

#include "fe_contact/solver/stopwatch.h"
#include "scene/error.h"
#include <cmath>
#include <limits>
#include <set>

namespace rimpact::fe {
namespace {

/// Forces below this are equilibrium for the residual's scale [N].
constexpr double smallest_force = 1e-2;

/// GMRES on a stale factor: relative residual, and iterations after which it is given up or the factor
/// renewed.
constexpr double linear_tolerance = 1e-3;
constexpr int most_linear_iterations = 20, worn_after = 6;

ContactOptions contact_options(const scene::Bearing &bearing, const meshes::RimMeshOptions &mesh,
                               const RimSolverOptions &options) {
  ContactOptions result;
  const double cell = 0.006 / std::pow(1.5, mesh.level - 1); // the meshes' target size in the contact zone
  result.law.penalty = options.penalty_factor * default_penalty(bearing.steel.E, cell);
  result.law.ceiling = 20 * bearing.steel.yield.value_or(bearing.steel.E / 100);
  result.gap_tolerance = options.gap_tolerance;
  return result;
}

} // namespace

/// Unknowns and results of one Newton iteration.
struct RimSolver::Trial {
  Eigen::VectorXd u;
  double multiplier = 0;
  SolidHistory history;
  ContactState contact;
  SolidEnergies energies;
  ContactReport report;
  Eigen::VectorXd residual, R; ///< residual = inertia - R; R = loads - internal - contact forces
  MasterLoad load;
  double scale = 0; ///< size of the forces in play [N]
  bool pattern_holds = true;
};

/// The terms of the time integrator in a step: u -> v, a.
struct RimSolver::Inertia {
  GeneralizedAlpha scheme;
  double dt;
  Eigen::VectorXd u_predicted, v_predicted, a_old;
  Eigen::VectorXd acceleration(const Eigen::VectorXd &u) const {
    return (u - u_predicted) / (scheme.beta * dt * dt);
  }
  Eigen::VectorXd velocity(const Eigen::VectorXd &a) const { return v_predicted + scheme.gamma * dt * a; }
  double mass_factor() const { return (1 - scheme.alpha_m) / (scheme.beta * dt * dt); }
  double velocity_factor() const { return scheme.gamma / (scheme.beta * dt); }
};

RimSolver::RimSolver(const scene::Bearing &bearing, const meshes::RimMeshOptions &mesh,
                     const RimSolverOptions &options)
    : RimSolver(bearing, meshes::rim_mesh(bearing, mesh), mesh, options) {}

RimSolver::RimSolver(const scene::Bearing &bearing, const meshes::HexMesh &own,
                     const meshes::RimMeshOptions &mesh, const RimSolverOptions &options)
    : half_(mesh.half), options_(options), space_(own, options.degree), solid_(space_, bearing),
      contact_(space_, meshes::Surface::slider_side, meshes::Surface::rim_wall,
               contact_options(bearing, mesh, options)) {
  make_equations(mesh);
  make_pattern(Eigen::VectorXd::Zero(space_.n_dofs()));
}

RimSolver::~RimSolver() = default;

void RimSolver::make_equations(const meshes::RimMeshOptions &mesh) {
  equations_.of_dof.assign(space_.n_dofs(), -2); // -2: not yet numbered
  equations_.weight.assign(space_.n_dofs(), 1.0);
  auto &of = equations_.of_dof;
  for (const unsigned node : space_.nodes_of(meshes::Surface::fixed))
    for (int i = 0; i < 3; ++i) of[3 * node + i] = -1;
  if (half_)
    for (const unsigned node : space_.nodes_of(meshes::Surface::symmetry)) of[3 * node + 1] = -1;
  const auto top = space_.nodes_of(meshes::Surface::top);
  for (int i = 0; i < 3; ++i) {
    master_[i] = half_ && i == 1 ? -1 : equations_.n++;
    for (const unsigned node : top) of[3 * node + i] = master_[i];
  }
  // The sector's cuts move within themselves: no displacement along the cut's normal.
  std::map<unsigned, int> tied_to_x; // y-dof = ratio * x-dof, numbered below
  for (const unsigned node : space_.nodes_of(meshes::Surface::sector_end)) {
    const Eigen::Vector3d &p = space_.positions[node];
    const double radius = p.head<2>().norm(), angle = std::atan2(p.y(), p.x());
    const bool inner = radius < mesh.plate_inner_radius + 1e-9;
    const bool end = std::abs(std::abs(angle) - mesh.sector_half_angle) < 1e-9;
    if (of[3 * node] == -1) continue;
    if ((inner && end) || (inner && of[3 * node + 1] == -1)) {
      of[3 * node] = of[3 * node + 1] = -1;
      continue;
    }
    const Eigen::Vector2d allowed = inner ? Eigen::Vector2d(-std::sin(angle), std::cos(angle))
                                          : Eigen::Vector2d(std::cos(angle), std::sin(angle));
    of[3 * node] = of[3 * node + 1] = equations_.n++;
    equations_.weight[3 * node] = allowed.x();
    equations_.weight[3 * node + 1] = allowed.y();
  }
  for (int &equation : of)
    if (equation == -2) equation = equations_.n++;

  std::set<unsigned> slider_nodes;
  for (std::size_t c = 0; c < space_.n_cells; ++c)
    if (space_.volumes[c] == meshes::Volume::upper_slider)
      slider_nodes.insert(&space_.cell_nodes[c * space_.nodes_per_cell],
                          &space_.cell_nodes[(c + 1) * space_.nodes_per_cell]);
  for (int i = 0; i < 3; ++i) {
    std::set<int> unique;
    for (const unsigned node : slider_nodes)
      if (of[3 * node + i] >= 0) unique.insert(of[3 * node + i]);
    slider_equations_[i].assign(unique.begin(), unique.end());
  }
}

void RimSolver::make_pattern(const Eigen::VectorXd &u) {
  const Stopwatch watch(time_split["search"]);
  auto near = contact_.cliques(u, equations_);
  pairs_.insert(pairs_.end(), near.begin(), near.end());
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
  auto cliques = solid_.cliques(equations_);
  cliques.push_back({master_[0], master_[1], master_[2]});
  cliques.insert(cliques.end(), pairs_.begin(), pairs_.end());
  direct_.reset();
  tangent_ = std::make_unique<SymmetricMatrix>(equations_.n, cliques);
  mass_ = std::make_unique<SymmetricMatrix>(equations_.n, cliques);
  solid_.add_mass(equations_, *mass_);
  const double extra =
      (options_.attached_mass - share() * solid_.mass_of(meshes::Volume::upper_slider)) / share();
  for (const int equation : master_)
    if (equation >= 0 && options_.attached_mass > 0) mass_->add(equation, equation, extra);
  direct_ = std::make_unique<DirectSolver>(*tangent_);
}

Eigen::Vector3d RimSolver::master_of(const Eigen::VectorXd &values) const {
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
    if (master_[i] >= 0) result[i] = values[master_[i]];
  return result;
}

ArcState RimSolver::virgin() const {
  ArcState state;
  state.u = state.v = state.a = state.R = Eigen::VectorXd::Zero(equations_.n);
  state.history = solid_.virgin();
  state.contact = contact_.open();
  return state;
}

bool RimSolver::evaluate(const ArcState &old, Trial &trial, bool with_contact, const Inertia *inertia,
                         const MasterLaw *law) {
  const Eigen::VectorXd u = equations_.expand(trial.u);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(equations_.n);
  tangent_->set_zero();
  trial.energies = {};
  {
    const Stopwatch watch(time_split["assembly"]);
    if (!solid_.assemble(u, old.history, trial.history, equations_, forces, tangent_.get(), trial.energies))
      return false;
  }
  trial.scale = forces.norm();
  trial.report = {};
  if (with_contact) {
    const Stopwatch watch(time_split["search"]);
    trial.report = contact_.assemble(u, trial.contact, equations_, &forces, tangent_.get());
    if (!trial.report.pattern_holds) {
      trial.pattern_holds = false;
      return false;
    }
  }
  trial.R = -forces;
  trial.residual = forces;
  if (!inertia) return true;

  const Eigen::VectorXd a = inertia->acceleration(trial.u), v = inertia->velocity(a);
  trial.load = (*law)(master_of(trial.u), master_of(v), trial.multiplier);
  for (int i = 0; i < 3; ++i) {
    if (master_[i] < 0) continue;
    trial.R[master_[i]] += trial.load.force[i] / share();
    for (int k = i; k < 3; ++k)
      if (master_[k] >= 0)
        tangent_->add(master_[i], master_[k],
                      -(0.5 * (trial.load.d_displacement(i, k) + trial.load.d_displacement(k, i)) +
                        inertia->velocity_factor() * 0.5 *
                            (trial.load.d_velocity(i, k) + trial.load.d_velocity(k, i))) /
                          share());
  }
  const double alpha_m = inertia->scheme.alpha_m;
  const Eigen::VectorXd inertial = mass_->multiply((1 - alpha_m) * a + alpha_m * inertia->a_old);
  trial.residual = inertial - trial.R;
  trial.scale += inertial.norm();
  for (std::size_t k = 0; k < mass_->n_entries(); ++k)
    tangent_->values()[k] += inertia->mass_factor() * mass_->values()[k];
  return true;
}

bool RimSolver::evaluate_on_a_pattern(const ArcState &old, Trial &trial, bool with_contact,
                                      const Inertia *inertia, const MasterLaw *law) {
  for (int builds = 0; builds < 4; ++builds) {
    trial.pattern_holds = true;
    if (evaluate(old, trial, with_contact, inertia, law)) return true;
    if (trial.pattern_holds) return false;
    make_pattern(equations_.expand(trial.u));
  }
  return false;
}

double RimSolver::relative_residual(const Trial &trial, bool prescribed) const {
  Eigen::VectorXd residual = trial.residual;
  for (const int equation : master_)
    if (prescribed && equation >= 0) residual[equation] = 0; // the top face is driven: its rows are dropped
  return residual.norm() / (trial.scale + smallest_force / options_.tolerance);
}

Eigen::VectorXd RimSolver::newton_change(Trial &trial, bool inertial, const Eigen::Vector3d *to_go,
                                         bool stale_factor, double &multiplier_change) {
  Eigen::VectorXd residual = trial.residual;
  if (to_go) { // the driven top face enters by its columns, then its rows become unit rows
    for (int i = 0; i < 3; ++i)
      for (int k = master_[i] < 0 ? 0 : tangent_->starts()[master_[i]];
           master_[i] >= 0 && k < tangent_->starts()[master_[i] + 1]; ++k)
        residual[tangent_->columns()[k]] += tangent_->values()[k] * (*to_go)[i];
    for (const int equation : master_)
      if (equation >= 0) {
        residual[equation] = 0;
        tangent_->make_unit_row(equation, 1e10);
      }
  }
  Eigen::VectorXd change;
  if (stale_factor) { // inexact Newton: a residual a thousand times smaller is what the next iteration can
                      // use
    const Stopwatch watch(time_split["solve"]);
    change = direct_->solve_iteratively(-residual, linear_tolerance, most_linear_iterations);
  }
  const bool fresh = change.size() == 0;
  if (fresh) {
    const Stopwatch watch(time_split["factor"]);
    if (!direct_->factorise()) return {};
  }
  const Stopwatch watch(time_split["solve"]);
  if (fresh) change = direct_->solve(-residual);
  factor_is_worn_ = !fresh && direct_->last_iterations() > worn_after;
  multiplier_change = 0;
  if (inertial && trial.load.constrained) { // bordered by the height's constraint
    Eigen::VectorXd push = Eigen::VectorXd::Zero(equations_.n), gradient = push;
    for (int i = 0; i < 3; ++i)
      if (master_[i] >= 0) {
        push[master_[i]] = trial.load.d_multiplier[i] / share();
        gradient[master_[i]] = trial.load.gradient[i];
      }
    const Eigen::VectorXd response =
        fresh ? direct_->solve(push) : direct_->solve_iteratively(push, linear_tolerance, most_linear_iterations);
    if (response.size() == 0) return {};
    multiplier_change = (-trial.load.constraint - gradient.dot(change)) / gradient.dot(response);
    change += multiplier_change * response;
  }
  for (int i = 0; i < 3 && to_go; ++i)
    if (master_[i] >= 0) change[master_[i]] = (*to_go)[i];
  return change;
}

StepReport RimSolver::iterate(const ArcState &old, Trial &trial, bool with_contact, const Inertia *inertia,
                              const MasterLaw *law, const Eigen::Vector3d *prescribed) {
  StepReport report;
  trial.contact = old.contact;
  if (!evaluate_on_a_pattern(old, trial, with_contact, inertia, law)) {
    report.reason = "a cell turned inside out";
    return report;
  }
  Eigen::Vector3d to_go =
      prescribed ? Eigen::Vector3d(*prescribed - master_of(trial.u)) : Eigen::Vector3d::Zero();
  double relative = relative_residual(trial, prescribed);
  bool first = true; // the first change carries the step's loading: its residual is no measure of progress
  for (int since_augmentation = 0;;) {
    report.residuals.push_back(relative);
    const bool on_the_dish = !trial.load.constrained || std::abs(trial.load.constraint) < 1e-11;
    if (relative < options_.tolerance && to_go.isZero() && on_the_dish && !(first && inertia)) {
      if (!with_contact || trial.report.penetration <= options_.gap_tolerance ||
          report.augmentations >= options_.max_augmentations) {
        report.converged = true;
        return report;
      }
      ++report.augmentations;
      since_augmentation = 0;
      WallContact::augment(trial.contact);
      evaluate_on_a_pattern(old, trial, with_contact, inertia, law);
      relative = relative_residual(trial, prescribed);
      continue;
    }
    if (since_augmentation++ >= options_.max_iterations) {
      report.reason = "Newton did not converge in " + std::to_string(options_.max_iterations) + " iterations";
      return report;
    }
    ++report.iterations;
    double multiplier_change = 0;
    // A factor of another pattern, or with other rows driven, is of no use; a worn one is renewed.
    const bool reuse =
        factored_for_ == tangent_->pattern_id() && !prescribed == !driven_factor_ && !factor_is_worn_;
    factored_for_ = tangent_->pattern_id();
    driven_factor_ = prescribed;
    const Eigen::VectorXd change =
        newton_change(trial, inertia, prescribed ? &to_go : nullptr, reuse, multiplier_change);
    if (change.size() == 0 || !change.allFinite()) {
      report.reason = "the tangent could not be factorised";
      return report;
    }
    to_go.setZero();
    // Backtracking, bounded: contact is not smooth, so after three halvings the best step found is taken.
    const Eigen::VectorXd u = trial.u;
    const double multiplier = trial.multiplier;
    double best = std::numeric_limits<double>::infinity(), best_factor = 0;
    for (double factor = 1.0; factor > 0.1; factor /= 2) {
      trial.u = u + factor * change;
      trial.multiplier = multiplier + factor * multiplier_change;
      const bool admissible = evaluate_on_a_pattern(old, trial, with_contact, inertia, law);
      const double reached = admissible ? relative_residual(trial, prescribed) : best;
      if (admissible && reached < best) {
        best = reached;
        best_factor = factor;
      }
      if (admissible && (first || reached < relative)) break;
      if (first && prescribed) break; // a driven face cannot go half the way
    }
    if (best_factor == 0) {
      report.reason = "a cell turned inside out";
      return report;
    }
    if (trial.u != u + best_factor * change) {
      trial.u = u + best_factor * change;
      trial.multiplier = multiplier + best_factor * multiplier_change;
      evaluate_on_a_pattern(old, trial, with_contact, inertia, law);
    }
    relative = best;
    first = false;
  }
}

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
  Trial trial;
  trial.u = state.u;
  StepReport report = iterate(state, trial, true, nullptr, nullptr, &target);
  if (!report.converged) return report;
  const ContactState before = state.contact;
  commit(state, trial);
  report.contact_work = share() * contact_.work(before, state.contact);
  report.rim_force = share() * state.report.force;
  if (half_) report.rim_force.y() = 0;
  return report;
}

StepReport RimSolver::relax(ArcState &state) {
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
  const GeneralizedAlpha scheme = GeneralizedAlpha::from(options_.rho_inf);
  const Inertia inertia{scheme, dt, scheme.predicted_displacement(state.u, state.v, state.a, dt),
                        scheme.predicted_velocity(state.v, state.a, dt), state.a};
  Trial trial;
  // Start from the last increment repeated: loading goes on mostly as it did. Where it does not, from the old
  // state.
  const bool extrapolate = state.last_dt > 0;
  trial.u = extrapolate ? Eigen::VectorXd(state.u + dt / state.last_dt * state.last_change) : state.u;
  trial.multiplier = multiplier;
  StepReport report = iterate(state, trial, true, &inertia, &law, nullptr);
  if (!report.converged && extrapolate) {
    const int spent = report.iterations;
    trial.u = state.u;
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

// Residual and tangent of a RimSolver, and the iteration that makes the residual vanish.
#include "fe_contact/runner/rim_trial.h"

#include "fe_contact/solver/newton.h"
#include "fe_contact/solver/stopwatch.h"
#include <cmath>
#include <limits>

namespace rimpact::fe {
namespace {

/// Forces below this are equilibrium for the residual's scale [N].
constexpr double smallest_force = 1e-2;

constexpr double finest_forcing = 1e-6;
constexpr double constraint_tolerance = 1e-9; ///< speed off the dish [m/s]

} // namespace

bool RimSolver::evaluate(const ArcState &old, Trial &trial, bool with_contact, const Inertia *inertia,
                         const MasterLaw *law) {
  const Eigen::VectorXd u = equations_.expand(trial.u);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(equations_.n);
  SymmetricMatrix *tangent = trial.keeps_tangent ? nullptr : tangent_.get();
  trial.keeps_tangent = false;
  if (tangent) tangent->set_zero();
  trial.energies = {};
  {
    const Stopwatch watch(time_split["assembly"]);
    if (!solid_.assemble(u, old.history, trial.history, equations_, forces, tangent, trial.energies))
      return false;
  }
  trial.scale = forces.norm();
  trial.report = {};
  if (with_contact) {
    const Stopwatch watch(time_split["search"]);
    trial.report = contact_.assemble(u, trial.contact, equations_, &forces, tangent);
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

Eigen::VectorXd RimSolver::newton_change(Trial &trial, const Inertia *inertia, const Eigen::Vector3d *to_go,
                                         bool stale_factor, double forcing, double &multiplier_change) {
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
  if (stale_factor) change = linear_->solve(-residual, forcing, most_linear_iterations);
  const bool fresh = change.size() == 0;
  if (fresh) change = linear_->solve_anew(-residual, forcing, most_linear_iterations);
  if (change.size() == 0) return {};
  factor_is_worn_ = !fresh && linear_->last_iterations() > worn_after;
  multiplier_change = 0;
  if (inertia && trial.load.constrained) { // bordered by the dish's constraint
    Eigen::VectorXd push = Eigen::VectorXd::Zero(equations_.n), gradient = push;
    for (int i = 0; i < 3; ++i)
      if (master_[i] >= 0) {
        push[master_[i]] = trial.load.d_multiplier[i] / share();
        gradient[master_[i]] = inertia->velocity_factor() * trial.load.gradient[i] + trial.load.by_displacement[i];
      }
    const Eigen::VectorXd response = linear_->solve(push, forcing, most_linear_iterations);
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
  WallContact::expect(trial.contact, trial.pressure_change);
  if (!evaluate_on_a_pattern(old, trial, with_contact, inertia, law)) {
    report.reason = "a cell turned inside out";
    return report;
  }
  Eigen::Vector3d to_go =
      prescribed ? Eigen::Vector3d(*prescribed - master_of(trial.u)) : Eigen::Vector3d::Zero();
  double relative = relative_residual(trial, prescribed);
  double forcing = 0;
  bool first = true; // the first change carries the step's loading: its residual is no measure of progress
  for (int since_augmentation = 0;;) {
    report.residuals.push_back(relative);
    const bool on_the_dish = !trial.load.constrained || std::abs(trial.load.constraint) < constraint_tolerance;
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
    forcing = forcing_term(report.residuals, forcing, options_.tolerance, finest_forcing);
    double multiplier_change = 0;
    // A factor of another pattern, or with other rows driven, is of no use; a worn one is renewed.
    const bool reuse =
        factored_for_ == tangent_->pattern_id() && !prescribed == !driven_factor_ && !factor_is_worn_;
    factored_for_ = tangent_->pattern_id();
    driven_factor_ = prescribed;
    const Eigen::VectorXd change =
        newton_change(trial, inertia, prescribed ? &to_go : nullptr, reuse, forcing, multiplier_change);
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

} // namespace rimpact::fe

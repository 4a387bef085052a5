#include "fe_contact/model/contact_system.h"

#include "fe_contact/solver/ranks.h"
#include "fe_contact/solver/stopwatch.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace rimpact::fe {
namespace {
/// Newton's usual tolerance: residuals below rounding over this count as solved.
constexpr double usual_tolerance = 1e-8;
}

ContactSystem::ContactSystem(const Discretisation &space, const Solid &solid, Equations equations)
    : space_(space), solid_(solid), equations_(std::move(equations)) {
  for (const auto &x : space.positions) size_ = std::max(size_, x.norm());
}

void ContactSystem::add_contact(meshes::Surface slave, const MasterSurface &master,
                                const SurfaceContactOptions &options) {
  contacts_.emplace_back(space_, slave, master, options);
}

void ContactSystem::add_mass(int dof, double mass) { body_masses_.emplace_back(dof, mass); }

void ContactSystem::make_pattern(const Eigen::VectorXd &displacements, const std::vector<SurfaceContactState> &states) {
  const Stopwatch watch(time_split["search"]);
  ++patterns_made_;
  auto cliques = solid_.cliques(equations_);
  for (std::size_t i = 0; i < contacts_.size(); ++i)
    for (auto &clique : contacts_[i].cliques(equations_, displacements, states[i].opposite))
      cliques.push_back(std::move(clique));
  solid_tangent_ = std::make_unique<SymmetricMatrix>(equations_.n, cliques);
  mass_ = std::make_unique<SymmetricMatrix>(equations_.n, cliques);
  solid_.add_mass(equations_, *mass_);
  for (const auto &[dof, mass] : body_masses_)
    for (int i = 0; i < 3; ++i)
      if (const int equation = equations_.of_dof[dof + i]; equation >= 0) mass_->add(equation, equation, mass);
  tangent_ = std::make_unique<GeneralMatrix>(*solid_tangent_);
  solver_ = std::make_unique<LinearSolver>(*tangent_, time_split);
}

SystemState ContactSystem::at_rest() {
  SystemState state;
  state.u = state.v = state.a = state.R = Eigen::VectorXd::Zero(equations_.n);
  state.history = solid_.virgin();
  for (const auto &contact : contacts_) state.contacts.push_back(contact.open(equations_.expand(state.u)));
  start_afresh_at(state);
  state.reports.resize(contacts_.size());
  return state;
}

void ContactSystem::prepare(const SystemState &old, const StepTerms &terms) {
  old_ = &old;
  terms_ = &terms;
  trial_.contacts = old.contacts;
}

bool ContactSystem::evaluate(const Eigen::VectorXd &u) {
  bool pattern_holds = true;
  const bool admissible = evaluate_on_the_pattern(u, pattern_holds);
  if (pattern_holds || !admissible) return admissible;
  make_pattern(equations_.expand(u), trial_.contacts);
  return evaluate_on_the_pattern(u, pattern_holds) && pattern_holds; // a pair still missing would lose its forces
}

bool ContactSystem::evaluate_on_the_pattern(const Eigen::VectorXd &u, bool &pattern_holds) {
  const Eigen::VectorXd displacements = equations_.expand(u);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(equations_.n);
  solid_tangent_->set_zero();
  trial_.energies = {};
  {
    const Stopwatch watch(time_split["assembly"]);
    if (!solid_.assemble(displacements, old_->history, trial_.history, equations_, forces, solid_tangent_.get(),
                         trial_.energies))
      return false;
  }
  const Stopwatch watch(time_split["search"]);
  Eigen::VectorXd spent = forces.cwiseAbs();
  // Of the tangent every rank has the share of its cells and faces, and the first one what belongs to none.
  const bool first = ranks().first();
  if (terms_->inertia && first) {
    const double factor = terms_->inertia->mass_factor();
    for (std::size_t k = 0; k < mass_->n_entries(); ++k)
      solid_tangent_->values()[k] += factor * mass_->values()[k];
  }
  tangent_->assign(*solid_tangent_);
  if (!first) forces.setZero(); // until they are summed up with the contacts'
  trial_.reports.assign(contacts_.size(), {});
  for (std::size_t i = 0; i < contacts_.size(); ++i)
    trial_.reports[i] = contacts_[i].assemble(displacements, trial_.contacts[i], terms_->dt, equations_, forces,
                                              tangent_.get());
  ranks().sum(forces);
  pattern_holds = std::all_of(trial_.reports.begin(), trial_.reports.end(), [](const auto &r) { return r.pattern_holds; });
  trial_.R = terms_->load - forces;
  residual_ = -trial_.R;
  // Coordinates are known to rounding, forces therefore to rounding times stiffness times size.
  Eigen::VectorXd diagonal(equations_.n);
  for (int i = 0; i < equations_.n; ++i) diagonal[i] = tangent_->diagonal(i);
  ranks().sum(diagonal);
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * diagonal.norm() * size_;
  scale_ = spent.norm() + terms_->load.norm() + rounding / usual_tolerance;
  if (const Inertia *inertia = terms_->inertia) {
    const Eigen::VectorXd a = inertia->acceleration(u);
    const double alpha_m = inertia->scheme.alpha_m;
    const Eigen::VectorXd inertial = mass_->multiply((1 - alpha_m) * a + alpha_m * inertia->a_old);
    residual_ += inertial;
    scale_ += inertial.norm();
  }
  if (terms_->stabilisation > 0) {
    const Eigen::VectorXd springs = terms_->stabilisation * (u - old_->u);
    residual_ += springs;
    stabilisation_share_ = springs.norm() / scale_;
    for (int i = 0; first && i < equations_.n; ++i) tangent_->add(i, i, terms_->stabilisation);
  } else {
    stabilisation_share_ = 0;
  }
  for (const auto &[equation, target] : terms_->driven) {
    trial_.R[equation] = 0; // the drive's reaction balances it
    const double stiffness = std::abs(diagonal[equation] + terms_->stabilisation) + 1.0;
    tangent_->make_unit_row(equation, first ? stiffness : 0.0);
    residual_[equation] = stiffness * (u[equation] - target);
  }
  return residual_.allFinite();
}

int ContactSystem::lost_points() const {
  int lost = 0;
  for (const auto &report : trial_.reports) lost += report.lost;
  return lost;
}

ContactSystem::Left ContactSystem::left_to_augment() {
  Left left;
  augmentations_.clear();
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    augmentations_.push_back(contacts_[i].augmentation(trial_.contacts[i]));
    left.gap = std::max(left.gap, augmentations_[i].gap_left);
    left.slip = std::max(left.slip, augmentations_[i].slip_left);
  }
  return left;
}

void ContactSystem::augment() {
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    trial_.contacts[i].multiplier = augmentations_[i].multiplier;
    trial_.contacts[i].tangential = augmentations_[i].tangential;
  }
}

bool ContactSystem::stiffen(double factor) {
  const double inertial = terms_->inertia && ranks().first() ? terms_->inertia->mass_factor() : 0.0;
  Eigen::VectorXd stiffness(equations_.n);
  for (int i = 0; i < equations_.n; ++i) stiffness[i] = solid_tangent_->diagonal(i) - inertial * mass_->diagonal(i);
  bool any = false;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    auto &stiffening = trial_.contacts[i].stiffening;
    const double most = contacts_[i].stiffness_per_area(equations_, stiffness) / contacts_[i].options().law.normal_penalty;
    if (stiffening * factor > std::max(1.0, most)) continue;
    stiffening *= factor;
    any = true;
  }
  return any;
}

void ContactSystem::commit(const Eigen::VectorXd &u, SystemState &state, NextMultipliers normal) const {
  const Eigen::VectorXd displacements = equations_.expand(u);
  state.reports = trial_.reports;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    contacts_[i].add_work(state.contacts[i], trial_.contacts[i], displacements, state.reports[i]);
    state.contacts[i] = trial_.contacts[i];
    contacts_[i].commit(displacements, state.contacts[i], normal);
  }
  state.u = u;
  state.R = trial_.R;
  state.history = trial_.history;
  state.energies = trial_.energies;
}

} // namespace rimpact::fe

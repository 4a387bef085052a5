#include "fe_contact/engine/contact_system.h"

#include "fe_contact/solver/ranks.h"
#include "fe_contact/solver/stopwatch.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace rimpact::fe {
namespace {
/// Newton's usual tolerance: residuals below rounding over this count as solved.
constexpr double usual_tolerance = 1e-8;
} // namespace

ContactSystem::ContactSystem(const Discretisation &space, const Solid &solid, Equations equations)
    : space_(space), solid_(solid), equations_(std::move(equations)) {
  for (const auto &x : space.positions) size_ = std::max(size_, x.norm());
}

void ContactSystem::add_contact(meshes::Surface slave, const MasterSurface &master,
                                const SurfaceContactOptions &options) {
  contacts_.emplace_back(space_, slave, master, options);
}

void ContactSystem::add_mass(int dof, double mass) {
  body_masses_.emplace_back(dof, mass);
}

void ContactSystem::make_pattern(const Eigen::VectorXd &displacements, const std::vector<SurfaceContactState> &states) {
  const Stopwatch watch(time_split["search"]);
  Couplings beside = ties_.couplings();
  beside.push_back(remote_);
  for (std::size_t i = 0; i < contacts_.size(); ++i)
    for (auto &coupling : contacts_[i].couplings(equations_, displacements, states[i].opposite))
      beside.push_back(std::move(coupling));
  if (tangent_ && tangent_->symmetry() == symmetry() && beside == beside_solids_) return tangent_->solver().forget();
  beside_solids_ = std::move(beside);
  tangent_ =
      std::make_unique<Tangent>(equations_.n, solid_.own_couplings(equations_), beside_solids_, symmetry(), time_split);
  if (!mass_) mass_.emplace(solid_, equations_, body_masses_);
  mass_->find_places(tangent_->symmetric());
}

Symmetry ContactSystem::symmetry() const {
  const bool friction = std::any_of(contacts_.begin(), contacts_.end(), [](const auto &contact) {
    const FrictionCoefficient &mu = contact.law().friction;
    return mu.fast > 0 || mu.slow > 0;
  });
  return friction ? Symmetry::general : Symmetry::symmetric;
}

SystemState ContactSystem::at_rest() {
  SystemState state;
  state.u = state.v = state.a = state.R = Eigen::VectorXd::Zero(equations_.n);
  state.history = solid_.initial_history();
  for (const auto &contact : contacts_) state.contacts.push_back(contact.open(equations_.expand(state.u)));
  start_afresh_at(state);
  state.reports.resize(contacts_.size());
  return state;
}

void ContactSystem::prepare(const SystemState &old, const StepTerms &terms) {
  old_ = &old;
  terms_ = &terms;
  answers_.begin();
  const bool knows_remote = !terms.remote || std::ranges::equal(remote_, terms.remote->face.equation);
  if (!knows_remote) remote_.assign(std::begin(terms.remote->face.equation), std::end(terms.remote->face.equation));
  // Friction was set or taken away, or there is another remote displacement.
  if (tangent_->symmetry() != symmetry() || !knows_remote) make_pattern(equations_.expand(old.u), old.contacts);
  trial_.contacts = old.contacts;
  for (auto &contact : trial_.contacts)
    if (terms.expected > 0) contact.expect(terms.expected);
  has_border_ = false;
  if (terms.remote) border_.multiplier = terms.remote->multiplier;
}

bool ContactSystem::evaluate(const Eigen::VectorXd &u, bool with_tangent) {
  bool pattern_holds = true;
  const bool admissible = evaluate_on_the_pattern(u, with_tangent, pattern_holds);
  if (pattern_holds || !admissible) return admissible;
  make_pattern(equations_.expand(u), trial_.contacts);
  return evaluate_on_the_pattern(u, true, pattern_holds) && pattern_holds; // a pair still missing would lose its forces
}

bool ContactSystem::evaluate_on_the_pattern(const Eigen::VectorXd &u, bool with_tangent, bool &pattern_holds) {
  const Eigen::VectorXd displacements = equations_.expand(u);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(equations_.n);
  if (with_tangent && exactly) solid_.forget_tangents();
  SymmetricMatrix *solid_tangent = with_tangent ? &tangent_->symmetric() : nullptr;
  if (with_tangent) start_tangent();
  trial_.energies = {};
  {
    const Stopwatch watch(time_split["assembly"]);
    if (!solid_.assemble(displacements, old_->history, trial_.history, equations_, forces, solid_tangent,
                         trial_.energies, terms_->dt, &answers_))
      return false;
  }
  if (with_tangent) solid_diagonal_ = tangent_->symmetric().diagonal();
  const Stopwatch watch(time_split["search"]);
  const double spent = forces.cwiseAbs().norm();
  if (!ranks().first()) forces.setZero(); // until they are summed up with the contacts'
  if (ranks().first()) ties_.add_forces(u, forces);
  trial_.energies.elastic += ties_.energy(u);
  pattern_holds = assemble_contacts(displacements, forces, with_tangent ? tangent_.get() : nullptr);
  trial_.R = terms_->load - forces;
  residual_ = -trial_.R;
  if (with_tangent) take_diagonal(); // without the ties: they feel displacements, which have no rounding of coordinates
  if (with_tangent && ranks().first()) ties_.add_tangent(*tangent_);
  scale_ = spent + terms_->load.norm() + rounding_ / usual_tolerance;
  if (terms_->inertia) add_inertia(u);
  if (terms_->inertia && terms_->remote) add_remote(u, with_tangent);
  stabilisation_share_ = 0;
  if (terms_->stabilisation > 0) {
    const Eigen::VectorXd springs = terms_->stabilisation * (u - old_->u);
    residual_ += springs;
    stabilisation_share_ = springs.norm() / scale_;
    for (int i = 0; with_tangent && ranks().first() && i < equations_.n; ++i)
      tangent_->symmetric().add(i, i, terms_->stabilisation);
  }
  if (!terms_->driven.empty()) drive(u, with_tangent);
  return residual_.allFinite();
}

bool ContactSystem::eliminate(Eigen::VectorXd &u) {
  const Stopwatch watch(time_split["assembly"]);
  std::vector<int> held; // what is prescribed, or carries the mass and with it forces that no cell has
  for (const auto &driven : terms_->driven) held.push_back(driven.equation);
  if (terms_->remote)
    held.insert(held.end(), std::begin(terms_->remote->face.equation), std::end(terms_->remote->face.equation));
  if (!elimination_) elimination_.emplace(solid_, equations_);
  return elimination_->solve(u, {residual_, *tangent_, old_->history, terms_->dt, held});
}

/// Of the tangent every rank has the share of its cells and faces, and the first one what belongs to none.
void ContactSystem::start_tangent() const {
  tangent_->set_zero();
  if (terms_->inertia) mass_->put(terms_->inertia->mass_factor(), tangent_->symmetric());
}

/// Coordinates are known to rounding, forces therefore to rounding times stiffness times size.
void ContactSystem::take_diagonal() {
  diagonal_.resize(equations_.n);
  for (int i = 0; i < equations_.n; ++i) diagonal_[i] = tangent_->diagonal(i);
  ranks().all_reduce_sum(diagonal_);
  rounding_ = 4 * std::numeric_limits<double>::epsilon() * diagonal_.norm() * size_;
}

bool ContactSystem::assemble_contacts(const Eigen::VectorXd &displacements, Eigen::VectorXd &forces, Tangent *tangent) {
  trial_.reports.assign(contacts_.size(), {});
  for (std::size_t i = 0; i < contacts_.size() && terms_->with_contact; ++i)
    trial_.reports[i] =
        contacts_[i].assemble(displacements, trial_.contacts[i], terms_->dt, equations_, forces, tangent);
  ranks().all_reduce_sum(forces);
  return std::all_of(trial_.reports.begin(), trial_.reports.end(), [](const auto &r) { return r.pattern_holds; });
}

void ContactSystem::add_inertia(const Eigen::VectorXd &u) {
  const Inertia &inertia = *terms_->inertia;
  const double alpha_m = inertia.scheme.alpha_m;
  const Eigen::VectorXd inertial =
      mass_->whole().multiply((1 - alpha_m) * inertia.acceleration(u) + alpha_m * inertia.a_old);
  residual_ += inertial;
  scale_ += inertial.norm();
}

void ContactSystem::add_remote(const Eigen::VectorXd &u, bool with_tangent) {
  constexpr double constraint_tolerance = 1e-9; // [m/s]
  const Inertia &inertia = *terms_->inertia;
  const RemoteTerms &remote = *terms_->remote;
  const auto &at = remote.face.equation;
  const RemoteLoad load =
      remote.law(remote.face.of(u), remote.face.of(inertia.velocity(inertia.acceleration(u))), border_.multiplier);
  const Eigen::Matrix3d stiffness = -(load.d_displacement + inertia.velocity_factor() * load.d_velocity) / remote.share;
  has_border_ = load.constrained;
  border_.push = border_.gradient = Eigen::VectorXd::Zero(equations_.n);
  border_.constraint = load.constraint;
  border_.tolerance = constraint_tolerance;
  for (int i = 0; i < 3; ++i) {
    if (at[i] < 0) continue;
    trial_.R[at[i]] += load.force[i] / remote.share;
    residual_[at[i]] -= load.force[i] / remote.share;
    border_.push[at[i]] = load.d_multiplier[i] / remote.share;
    border_.gradient[at[i]] = inertia.velocity_factor() * load.gradient[i] + load.by_displacement[i];
    for (int k = 0; k < 3 && with_tangent && ranks().first(); ++k)
      if (at[k] >= 0) tangent_->add(at[i], at[k], stiffness(i, k));
  }
}

void ContactSystem::drive(const Eigen::VectorXd &u, bool with_tangent) {
  const auto stiffness = [&](int equation) { return std::abs(diagonal_[equation] + terms_->stabilisation) + 1.0; };
  if (with_tangent) {
    Eigen::VectorXd moved = Eigen::VectorXd::Zero(equations_.n);
    for (const auto &[equation, target] : terms_->driven)
      tangent_->drive(equation, ranks().first() ? stiffness(equation) : 0.0, u[equation] - target, moved);
    ranks().all_reduce_sum(moved);
    residual_ += moved;
  }
  for (const auto &[equation, target] : terms_->driven) {
    trial_.R[equation] = 0; // the drive's reaction balances it
    residual_[equation] = stiffness(equation) * (u[equation] - target);
  }
}

int ContactSystem::lost_points() const {
  int lost = 0;
  for (const auto &report : trial_.reports) lost += report.lost;
  return lost;
}

ContactSystem::Left ContactSystem::augmentation_residual() {
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
  const double inertial = terms_->inertia ? terms_->inertia->mass_factor() : 0.0;
  Eigen::VectorXd stiffness = solid_diagonal_;
  for (int i = 0; i < equations_.n; ++i) stiffness[i] -= inertial * mass_->own_diagonal(i);
  bool any = false;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    auto &stiffening = trial_.contacts[i].stiffening;
    const double most =
        contacts_[i].search().stiffness_per_area(equations_, stiffness) / contacts_[i].law().normal_penalty;
    if (stiffening * factor > std::max(1.0, most)) continue;
    stiffening *= factor;
    any = true;
  }
  return any;
}

void ContactSystem::commit(const Eigen::VectorXd &u, SystemState &state, const Renewal &renewal) const {
  const Eigen::VectorXd displacements = equations_.expand(u);
  state.reports = trial_.reports;
  for (std::size_t i = 0; i < contacts_.size() && terms_->with_contact; ++i) {
    const auto places = contacts_[i].places(displacements, trial_.contacts[i]);
    contacts_[i].add_work(state.contacts[i], trial_.contacts[i], places, state.reports[i]);
    const std::vector<double> pressure = state.contacts[i].pressure;
    state.contacts[i] = trial_.contacts[i];
    contacts_[i].commit(displacements, places, state.contacts[i], renewal);
    state.contacts[i].note_change(pressure);
  }
  state.u = u;
  state.R = trial_.R;
  state.history = trial_.history;
  solid_.all_gather(state.history, equations_);
  state.energies = trial_.energies;
}

} // namespace rimpact::fe

/// Deformable solids, their contacts with exact surfaces, rigid bodies and dead loads, assembled into one
/// residual and its tangent, unsymmetric where there is friction. Knows no bearing and no time loop.
#pragma once
#include "fe_contact/engine/nonlinear_elimination.h"
#include "fe_contact/engine/remote_load.h"
#include "fe_contact/engine/solid.h"
#include "fe_contact/engine/stiff_ties.h"
#include "fe_contact/engine/surface_contact.h"
#include "fe_contact/engine/system_mass.h"
#include "fe_contact/solver/generalized_alpha.h"
#include "fe_contact/solver/newton.h"
#include "fe_contact/solver/tangent.h"
#include <map>
#include <optional>

namespace rimpact::fe {

/// Committed state; vectors by equation, SI units.
struct SystemState {
  Eigen::VectorXd u, v, a;
  Eigen::VectorXd R;             ///< loads less internal and contact forces [N]: what accelerates the equations
  Eigen::VectorXd last_change;   ///< of u over the last step in time, from which the next one's first guess is made
  double last_dt = 0;            ///< [s]; 0: none
  Eigen::VectorXd change_before; ///< likewise, over the step before that one
  double dt_before = 0;          ///< [s]; 0: none
  int growth_hold = 0;           ///< steps that are not to grow, one before them did not converge
  double refused_error = 0;      ///< for which the last step tried from here was not taken [tolerances]; 0: none was
  SolidHistory history;
  std::vector<SurfaceContactState> contacts;
  SolidEnergies energies;
  std::vector<SurfaceContactReport> reports;
  int bearing_points() const; ///< of all contacts
};

/// An equation whose value is given.
struct Driven {
  int equation;
  double target; ///< [m]
};

/// What the ground does over a step, exactly: its acceleration at both ends, the change of its velocity, and of its
/// displacement beyond what its velocity at the start brings.
struct GroundStep {
  Eigen::Vector3d a_old, a_new, velocity, displacement;
  GroundStep operator/(double by) const { return {a_old / by, a_new / by, velocity / by, displacement / by}; }
};

/// The terms of a step in time: u -> v, a.
struct Inertia {
  GeneralizedAlpha scheme;
  double dt; ///< [s]
  Eigen::VectorXd u_predicted, v_predicted, a_old;
  Inertia(const GeneralizedAlpha &scheme, double dt, const SystemState &old)
      : scheme(scheme), dt(dt), u_predicted(scheme.predicted_displacement(old.u, old.v, old.a, dt)),
        v_predicted(scheme.predicted_velocity(old.v, old.a, dt)), a_old(old.a) {}
  Eigen::VectorXd acceleration(const Eigen::VectorXd &u) const { return (u - u_predicted) / (scheme.beta * dt * dt); }
  double mass_factor() const { return (1 - scheme.alpha_m) / (scheme.beta * dt * dt); } ///< of the tangent [1/s^2]
  double velocity_factor() const { return scheme.gamma / (scheme.beta * dt); }          ///< dv/du [1/s]
  Eigen::VectorXd velocity(const Eigen::VectorXd &a) const { return v_predicted + scheme.gamma * dt * a; }
};

/// What a step asks of the system besides its state.
struct StepTerms {
  Eigen::VectorXd load; ///< dead loads by equation [N]
  std::vector<Driven> driven{};
  double dt = 0;            ///< [s]; 0: friction at its static coefficient, steel without rate
  double stabilisation = 0; ///< springs to the old state on every equation [N/m]
  const Inertia *inertia = nullptr;
  std::optional<GroundStep> ground{};  ///< of a step in time, whose load holds the inertia forces of a_new
  const RemoteTerms *remote = nullptr; ///< with inertia only
  bool with_contact = true;            ///< false: the bodies pass through one another
  /// The pressures' change over the last step, as often, is expected of this one's multipliers too; 0: they start as
  /// they are.
  double expected = 0;
};

class ContactSystem : public NewtonTarget {
public:
  ContactSystem(const Discretisation &space, const Solid &solid, Equations equations);
  ContactSystem(const ContactSystem &) = delete; // parts of it refer to one another
  ContactSystem &operator=(const ContactSystem &) = delete;
  /// Contacts, ties and bodies' masses are added before the first state is made.
  void add_contact(meshes::Surface slave, const MasterSurface &master, const SurfaceContactOptions &options);
  void add_mass(int dof, double mass); ///< of a rigid body, on its three dofs [kg]
  void add_tie(std::vector<StiffTies::Term> terms, double stiffness) { ties_.add(std::move(terms), stiffness); }

  SystemState at_rest();
  /// Forgets what a state does not hold, tangents, factor and the pattern's history, and goes on from the state alone.
  /// To be called where a checkpoint is written and where it is read: both runs then go on alike, bit for bit.
  void start_afresh_at(const SystemState &state) {
    solid_.forget_tangents();
    remote_.clear();
    make_pattern(equations_.expand(state.u), state.contacts);
  }
  /// Sets what the next Newton solution is of; `old` and `terms` must outlive it.
  void prepare(const SystemState &old, const StepTerms &terms);
  bool evaluate(const Eigen::VectorXd &u, bool with_tangent) override;
  bool eliminate(Eigen::VectorXd &u) override;
  const Eigen::VectorXd &residual() const override { return residual_; }
  double force_scale() const override { return scale_; }
  LinearSolver &solver() override { return tangent_->solver(); }
  BorderingConstraint *border() override { return has_border_ ? &border_ : nullptr; }
  /// What the next augmentation would mend of the trial, in its multipliers' sense [m]; then: makes it.
  struct Left {
    double gap = 0, slip = 0;
  };
  Left augmentation_residual();
  void augment();
  /// Multiplies the trial's penalties, but never beyond the solid's own stiffness at the contact, without its inertia
  /// (stiffer ones over-constrain the faces, and stay when the steps are long again); false when none could be.
  bool stiffen(double factor);
  /// The trial, evaluated at u, becomes the state. All ranks call it together.
  void commit(const Eigen::VectorXd &u, SystemState &state, const Renewal &renewal) const;

  Eigen::VectorXd expand(const SystemState &state) const { return equations_.expand(state.u); }
  Eigen::VectorXd translation(const Eigen::Vector3d &way) const;       ///< of all that is not held, by equation
  Eigen::VectorXd gravity(const Eigen::Vector3d &acceleration) const { ///< loads of all masses [N]
    return mass_->whole().multiply(translation(acceleration));
  }
  /// Dead traction [Pa] on a group's reference faces, by position and outward normal.
  using Traction = std::function<Eigen::Vector3d(const Eigen::Vector3d &x, const Eigen::Vector3d &normal)>;
  Eigen::VectorXd surface_load(meshes::Surface group, const Traction &traction) const;
  double kinetic_energy(const SystemState &state) const { return 0.5 * state.v.dot(mass_->whole().multiply(state.v)); }
  Eigen::VectorXd mass_times(const Eigen::VectorXd &a) const { return mass_->whole().multiply(a); }
  /// Time until an open point would touch at present velocities [s]; infinity when none closes or one is in
  /// contact already.
  double time_to_touch(const SystemState &state) const;

  const Discretisation &space() const { return space_; }
  const Solid &solid() const { return solid_; }
  const Equations &equations() const { return equations_; }
  const SurfaceContact &contact(std::size_t i) const { return contacts_[i]; }
  SurfaceContact &contact(std::size_t i) { return contacts_[i]; }
  std::size_t n_contacts() const { return contacts_.size(); }
  int lost_points() const;                                 ///< of all contacts, last evaluation
  double multiplier() const { return border_.multiplier; } ///< of the remote displacement's constraint, last evaluation
  const StiffTies &ties() const { return ties_; }
  double stabilisation_share() const { return stabilisation_share_; } ///< of the forces in play, last evaluation

private:
  void make_pattern(const Eigen::VectorXd &displacements, const std::vector<SurfaceContactState> &states);
  bool evaluate_on_the_pattern(const Eigen::VectorXd &u, bool with_tangent, bool &pattern_holds);
  bool assemble_contacts(const Eigen::VectorXd &displacements, Eigen::VectorXd &forces, Tangent *tangent);
  void start_tangent() const;
  void take_diagonal();
  void add_inertia(const Eigen::VectorXd &u);
  void add_remote(const Eigen::VectorXd &u, bool with_tangent);
  void drive(const Eigen::VectorXd &u, bool with_tangent);
  Symmetry symmetry() const;

  const Discretisation &space_;
  const Solid &solid_;
  Equations equations_;
  std::vector<SurfaceContact> contacts_;
  StiffTies ties_;
  std::vector<std::pair<int, double>> body_masses_;
  std::optional<SystemMass> mass_; ///< made with the first pattern, when all bodies are there
  std::unique_ptr<Tangent> tangent_;
  std::optional<NonlinearElimination> elimination_; ///< made when it is first asked for

  const SystemState *old_ = nullptr; ///< of the Newton solution under way
  const StepTerms *terms_ = nullptr;
  SystemState trial_;
  CellAnswers answers_; ///< of the trial
  std::vector<Augmentation> augmentations_;
  Eigen::VectorXd residual_, diagonal_; ///< diagonal: of the last tangent, before what is driven and stabilised
  Eigen::VectorXd solid_diagonal_;      ///< of this rank's cells alone, with their masses
  double rounding_ = 0;                 ///< of the forces [N]
  BorderingConstraint border_;
  bool has_border_ = false;
  double scale_ = 0, stabilisation_share_ = 0, size_ = 0;
  Couplings beside_solids_; ///< of the pattern at hand: ties, contacts, a remote displacement
  std::vector<int> remote_; ///< equations of the remote displacement; empty: none yet
};

} // namespace rimpact::fe

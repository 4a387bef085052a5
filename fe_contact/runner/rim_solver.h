/// The solids of rung R1 (rim sector with plate, upper slider) as something that can be pushed or stepped:
/// the only place that knows both the solids and the numerics. One RimSolver serves every arc; each arc has
/// its own ArcState.
///
/// Local frame: +x radially outwards through the arc's middle, z up. The master is the slider's top face
/// (remote displacement, no rotation); its displacement is measured from the position of first touch.
#pragma once
#include "fe_contact/model/solid.h"
#include "fe_contact/model/wall_contact.h"
#include "fe_contact/solver/generalized_alpha.h"
#include "fe_contact/solver/linear_solver.h"
#include "meshes/rim_mesh.h"
#include <functional>
#include <map>
#include <optional>

namespace rimpact::fe {

/// Committed state of one arc.
struct ArcState {
  Eigen::VectorXd u, v, a; ///< equations: displacement [m], velocity, acceleration
  SolidHistory history;
  ContactState contact;
  Eigen::VectorXd R; ///< forces that accelerate the equations (loads less internal and contact forces) [N]
  SolidEnergies energies;
  ContactReport report;
  Eigen::Vector3d master = Eigen::Vector3d::Zero(); ///< displacement of the top face [m]
  Eigen::Vector3d master_velocity = Eigen::Vector3d::Zero();
  Eigen::VectorXd last_change; ///< of u over the last step, the next one's first guess
  std::vector<double> last_pressure_change; ///< of the contact points over the last step [Pa]
  double last_dt = 0;          ///< [s], 0: none
};

/// What acts on the top face besides the solids, for the whole bearing (the solver halves it for a half
/// model).
struct MasterLoad {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Matrix3d d_displacement = Eigen::Matrix3d::Zero(); ///< symmetric part of d force / d u
  Eigen::Matrix3d d_velocity = Eigen::Matrix3d::Zero();
  bool constrained = false;                           ///< the dish carries the mass, or its height is held
  /// Speed off the dish, which must vanish [m/s]: held so, and not by the height itself, the multiplier stays of the size of
  /// the forces however short the step (index 2, not 3).
  double constraint = 0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();      ///< of it by the velocity
  Eigen::Vector3d by_displacement = Eigen::Vector3d::Zero(); ///< of it by the displacement
  Eigen::Vector3d d_multiplier = Eigen::Vector3d::Zero(); ///< d force / d multiplier
};
using MasterLaw =
    std::function<MasterLoad(const Eigen::Vector3d &u, const Eigen::Vector3d &v, double multiplier)>;

struct StepReport {
  bool converged = false;
  int iterations = 0, augmentations = 0;
  std::vector<double> residuals; ///< relative, one an iteration
  double multiplier = 0;
  double integrator_loss = 0;                          ///< [J], whole bearing
  double contact_work = 0;                             ///< [J]
  Eigen::Vector3d rim_force = Eigen::Vector3d::Zero(); ///< of the rim on the slider [N], whole bearing
  std::string reason;                                  ///< when not converged
};

struct RimSolverOptions {
  int degree = 2;
  double rho_inf = 0.5;
  double penalty_factor = 4.0;
  double gap_tolerance = 3e-5; ///< [m]
  int max_augmentations = 3;   ///< reported when reached
  int max_iterations = 15;
  double tolerance = 1e-5;  ///< relative residual
  double attached_mass = 0; ///< supported mass on the top face, the slider's own included [kg]
};

class RimSolver {
public:
  RimSolver(const scene::Bearing &bearing, const meshes::RimMeshOptions &mesh,
            const RimSolverOptions &options);
  /// On a mesh of one's own with the groups of rim_mesh.
  RimSolver(const scene::Bearing &bearing, const meshes::HexMesh &own, const meshes::RimMeshOptions &mesh,
            const RimSolverOptions &options);
  ~RimSolver();

  ArcState virgin() const;
  /// Quasi-static: moves the top face to `target`, everything else in equilibrium. State unchanged on
  /// failure.
  StepReport push(ArcState &state, const Eigen::Vector3d &target);
  /// One implicit step in time. State unchanged on failure.
  StepReport step(ArcState &state, double dt, const MasterLaw &law, double multiplier);
  /// Lets the parts come to rest with the walls apart and the top face held: the state kept for a next
  /// impact.
  StepReport relax(ArcState &state);
  /// Places the slider, at rest in itself, at a master displacement with a velocity and acceleration.
  void place(ArcState &state, const Eigen::Vector3d &master, const Eigen::Vector3d &velocity,
             const Eigen::Vector3d &acceleration) const;
  /// Adds a velocity to the whole slider.
  void kick(ArcState &state, const Eigen::Vector3d &velocity) const;
  /// Recomputes energies and the forces R of a state that was placed, not solved.
  void refresh_forces(ArcState &state, const MasterLaw &law, double multiplier);
  Eigen::Vector3d master_acceleration(const ArcState &state) const { return master_of(state.a); }
  const RimSolverOptions &options() const { return options_; }
  /// Smallest distance of the walls with the slider moved rigidly to a master displacement.
  double surface_gap(const ArcState &state, const Eigen::Vector3d &master) const;
  /// Kinetic energy of solids and mass, whole bearing [J]; of the mass moving with the top face alone.
  double kinetic_energy(const ArcState &state) const;
  double rigid_kinetic_energy(const Eigen::Vector3d &velocity) const;
  double share() const { return half_ ? 2.0 : 1.0; } ///< whole bearing over model

  int n_equations() const { return equations_.n; }
  const Discretisation &space() const { return space_; }
  const Solid &solid() const { return solid_; }
  const WallContact &contact() const { return contact_; }
  Eigen::VectorXd displacements(const ArcState &state) const { return equations_.expand(state.u); }
  double largest_plastic_strain(const ArcState &state) const;
  std::map<std::string, double> time_split; ///< [s]

private:
  struct Trial;
  struct Inertia;
  void make_equations();
  void hold_cuts();
  void make_pattern(const Eigen::VectorXd &u);
  bool evaluate(const ArcState &old, Trial &trial, bool with_contact, const Inertia *inertia,
                const MasterLaw *law);
  bool evaluate_on_a_pattern(const ArcState &old, Trial &trial, bool with_contact, const Inertia *inertia,
                             const MasterLaw *law);
  double relative_residual(const Trial &trial, bool prescribed) const;
  Eigen::VectorXd newton_change(Trial &trial, const Inertia *inertia, const Eigen::Vector3d *to_go, bool stale_factor, double forcing,
                                double &multiplier_change);
  StepReport iterate(const ArcState &old, Trial &trial, bool with_contact, const Inertia *inertia,
                     const MasterLaw *law, const Eigen::Vector3d *prescribed);
  void commit(ArcState &state, Trial &trial) const;
  Eigen::Vector3d master_of(const Eigen::VectorXd &values) const;

  bool half_;
  RimSolverOptions options_;
  Discretisation space_;
  Solid solid_;
  WallContact contact_;
  Equations equations_;
  int master_[3];                        ///< equations of the top face, -1 where fixed
  std::vector<int> slider_equations_[3]; ///< of the slider's nodes, by component, unique
  std::unique_ptr<SymmetricMatrix> mass_, tangent_;
  std::unique_ptr<LinearSolver> linear_;
  long factored_for_ = 0;               ///< pattern of the factor at hand
  bool factor_is_worn_ = false;         ///< GMRES needed many iterations with it
  bool driven_factor_ = false;          ///< it has unit rows for a driven top face
  Eigen::Vector3d last_push_ = Eigen::Vector3d::Zero(); ///< of the top face [m], the tangent at hand being its solution's; else zero
  std::vector<std::vector<int>> pairs_; ///< contact cliques in the pattern
};

} // namespace rimpact::fe

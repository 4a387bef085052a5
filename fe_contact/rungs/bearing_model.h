/// The solids of a rung on their mesh, and their equations: the top face is a remote displacement without rotation that
/// carries the supported mass. Of a slider that slides between two dishes it is the middle, about which it turns.
#pragma once
#include "fe_contact/engine/contact_steps.h"
#include "fe_contact/rungs/rim_foot.h"
#include "fe_contact/rungs/rim_frame.h"
#include "fe_contact/rungs/rung.h"
#include <optional>

namespace rimpact::fe {

struct ModelOptions {
  bool friction = true;       ///< false: dish and socket are smooth
  double penalty_scale = 1;   ///< of the contacts' penalties, times the default
  int degree = 2;             ///< of the cells' shapes
  double pad_retardation = 0; ///< theta of the pad's loss (laws/pad_loss.h) [s]
};

struct BearingModel {
  BearingModel(const Rung &rung, const scene::Bearing &bearing, const meshes::MeshOrder &mesh,
               const ModelOptions &options = {});
  BearingModel(const BearingModel &) = delete;

  double share() const { return mesh.half ? 2.0 : 1.0; }             ///< whole bearing over model, of forces
  double energy_share() const { return share() * bearing.dishes(); } ///< and of energies: two dishes stand in series
  /// A slider between two dishes that slides on them, and turns as it goes: u = 2 q, q the way of its middle.
  bool turns() const { return bearing.double_concave() && rung.dish != DishKind::law; }
  /// Its halves slide on one another, and the middle is no point of them (middle_plane.h).
  bool slips() const { return turns() && bearing.has_interface(); }
  double own_mass() const; ///< of the carried bodies, of one dish's side of the bearing [kg]

  const Rung &rung;
  const scene::Bearing bearing;
  const meshes::MeshOrder mesh;
  const ModelOptions options;
  const Discretisation space;
  const Solid solid;
  const RimFoot foot;
  const double rate_ratio; ///< velocity of what is carried over that of the top face, or of the slider's middle
};

/// Frictional contact with penalties `stiffer` times the stiffness of the softer side's cells: its E [Pa] over their
/// size, `cell` at level 1 [m].
SurfaceContactOptions penalised(const BearingModel &model, double E, double cell, const FrictionCoefficient &mu,
                                double stiffer = 1);

class BearingSystem : public ContactSystem {
public:
  /// `mass`: what the bearing carries, the carried bodies' own included [kg]; 0: none.
  BearingSystem(const BearingModel &model, double mass, RimState rim = RimState::solid);

  const BearingModel &model() const { return model_; }
  const RemoteFace &top() const { return top_; }
  Eigen::Vector3d top_of(const Eigen::VectorXd &by_equation) const { return top_.of(by_equation); }
  /// A vertical dead load of the whole bearing on the top face, down [N], by equation.
  Eigen::VectorXd dead_load(double vertical) const;

  const std::vector<Role> &roles() const { return roles_; } ///< of the contacts, in their order
  std::optional<std::size_t> contact_of(Role role) const;   ///< its number; none: the rung has no such pair
  /// Of a pair in a state; none: the rung has no such pair.
  const SurfaceContactReport *report_of(const SystemState &state, Role role) const;
  /// On the carried bodies, whole bearing [N]: all of the pair's, or its friction alone.
  Eigen::Vector3d force_of(const SystemState &state, Role role) const;
  Eigen::Vector3d friction_of(const SystemState &state, Role role) const;
  bool walls_touch(const SystemState &state) const;
  /// How far the slider's upper half is ahead of the lower one, or how fast; zero where it is one piece [m], [m/s].
  Eigen::Vector3d interface_slip(const Eigen::VectorXd &by_equation) const;
  /// Way of what is carried until the walls meet, as the last step left them: between two dishes of both rims together;
  /// `otherwise` where they are no pair, or nothing is opposite [m].
  double wall_distance(const SystemState &state, double otherwise) const;

  /// Moves the carried bodies, at rest in themselves, to a displacement of the top face, with a velocity and an
  /// acceleration; their contacts begin anew there.
  void set_position(SystemState &state, const Eigen::Vector3d &top, const Eigen::Vector3d &velocity,
                    const Eigen::Vector3d &acceleration) const;
  void apply_velocity_jump(SystemState &state,
                           const Eigen::Vector3d &velocity) const;      ///< adds it to the carried bodies
  void translate(Eigen::VectorXd &u, const Eigen::Vector3d &way) const; ///< of the carried bodies [m]
  /// The parts come to rest with their contacts apart and the top face held.
  ContactStepReport relax(SystemState &state, const StepOptions &options);
  /// Smallest distance of the walls with the carried bodies moved rigidly to a displacement of the top face [m].
  double wall_gap(const SystemState &state, const Eigen::Vector3d &top) const;
  /// Of `mass`, whole bearing, at a velocity of the top face [J].
  double rigid_kinetic_energy(const Eigen::Vector3d &velocity) const {
    return 0.5 * mass_ * std::pow(model_.rate_ratio, 2) * velocity.squaredNorm();
  }

private:
  BearingSystem(const BearingModel &model, double mass, RimState rim, Supports supports);
  Eigen::Vector3d whole(Eigen::Vector3d force) const; ///< of the model's force [N]

  const BearingModel &model_;
  double mass_;
  RemoteFace top_, ridden_;     ///< what carries the mass; the middle of the half that is solved
  std::vector<Role> roles_;     ///< of the contacts
  std::vector<int> carried_[3]; ///< equations of the carried bodies, by component
};

} // namespace rimpact::fe

/// The solids of rung rim: a sector of the rim with the plate below it, and the upper slider, at the place of first
/// touch. Local frame: +x radially outwards through the arc's middle, z up. One RimSystem serves every arc; each arc
/// has its own state.
#pragma once
#include "fe_contact/engine/contact_steps.h"
#include "fe_contact/engine/supports.h"
#include "meshes/rim_mesh.h"
#include "scene/scene.h"

namespace rimpact::fe {

struct RimModel {
  RimModel(const scene::Bearing &bearing, const meshes::RimMeshOptions &mesh, double penalty_scale = 1, int degree = 2);
  /// On a mesh of one's own with the groups of rim_mesh.
  RimModel(const scene::Bearing &bearing, const meshes::HexMesh &own, const meshes::RimMeshOptions &mesh,
           double penalty_scale = 1, int degree = 2);
  RimModel(const RimModel &) = delete;

  double share() const { return mesh.half ? 2.0 : 1.0; } ///< whole bearing over model
  double own_mass() const {
    return share() * solid.mass_of(meshes::Volume::upper_slider);
  } ///< of the slider, whole bearing [kg]

  const scene::Bearing bearing;
  const meshes::RimMeshOptions mesh;
  const double penalty_scale;
  const Discretisation space;
  const Solid solid;
};

/// Its equations. The slider's top face is a remote displacement without rotation, measured from the place of first
/// touch; it carries the supported mass. The only contact is that of the walls.
class RimSystem : public ContactSystem {
public:
  /// `mass`: on the top face, the slider's own included [kg]; 0: none.
  RimSystem(const RimModel &model, double mass);

  const RimModel &model() const { return model_; }
  const RemoteFace &top() const { return top_; }
  /// Puts the slider, at rest in itself, at a displacement of its top face, with a velocity and acceleration; the
  /// walls' contact begins anew there.
  void place(SystemState &state, const Eigen::Vector3d &top, const Eigen::Vector3d &velocity,
             const Eigen::Vector3d &acceleration) const;
  void kick(SystemState &state, const Eigen::Vector3d &velocity) const; ///< adds it to the whole slider
  /// Quasi-static: the top face goes to `target`.
  ContactStepReport push(SystemState &state, const Eigen::Vector3d &target, const StepOptions &options);
  /// The parts come to rest with the walls apart and the top face held.
  ContactStepReport relax(SystemState &state, const StepOptions &options);
  /// Smallest distance of the walls with the slider moved rigidly to a displacement of its top face [m].
  double wall_gap(const SystemState &state, const Eigen::Vector3d &top) const;
  double rigid_kinetic_energy(const Eigen::Vector3d &velocity) const {
    return 0.5 * mass_ * velocity.squaredNorm();
  }                                                           ///< whole bearing [J]
  Eigen::Vector3d wall_force(const SystemState &state) const; ///< of the rim on the slider, whole bearing [N]

private:
  RimSystem(const RimModel &model, double mass, Supports supports);
  const RimModel &model_;
  double mass_;
  RemoteFace top_;
  std::vector<int> slider_[3];                         ///< equations of the slider, by component
  Eigen::VectorXd last_change_;                        ///< of u over the last push
  Eigen::Vector3d last_way_ = Eigen::Vector3d::Zero(); ///< of the top face then [m]
};

} // namespace rimpact::fe

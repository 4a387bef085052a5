/// The solids of rungs rigid-dish and full: pad (tied to the foot), foot and upper slider, and of rigid-dish the rim's
/// sectors where a scene needs them, its dish being exact; of full the whole plate, whose deformed dish carries the
/// exact surface. Frame and reference position: at rest on the vertex (see stack_mesh).
#pragma once
#include "fe_contact/engine/contact_steps.h"
#include "fe_contact/engine/supports.h"
#include "meshes/stack_mesh.h"

namespace rimpact::fe {

struct StackModel {
  StackModel(const scene::Bearing &bearing, const meshes::StackMeshOptions &mesh, bool friction = true,
             double penalty_scale = 1);
  StackModel(const StackModel &) = delete;

  double share() const { return mesh.half ? 2.0 : 1.0; } ///< whole bearing over model
  bool full() const { return mesh.whole_plate; }         ///< rung full
  double own_mass() const; ///< of the parts that move with the supported mass, whole bearing [kg]

  const scene::Bearing bearing;
  const meshes::StackMeshOptions mesh;
  const bool friction;        ///< false: dish and socket are smooth
  const double penalty_scale; ///< of the contacts, times the default
  const Discretisation space;
  const Solid solid;
};

/// The model's equations, with the rim's solids or with these held: the rim joins only while it may be touched.
/// Contacts: dish-pad, cap-socket and, with the rim, wall-slider.
class StackSystem : public ContactSystem {
public:
  StackSystem(const StackModel &model, bool with_rim);

  bool with_rim() const { return with_rim_; }
  /// Equation of a component of the upper slider's top face (remote displacement, no rotation); -1: held.
  int top(int component) const { return top_.equation[component]; }
  Eigen::Vector3d top_of(const Eigen::VectorXd &by_equation) const { return top_.of(by_equation); }
  /// The supported mass, in translation with the top face; to be called before the first state is made [kg].
  void carry(double mass);
  /// A vertical dead load of the whole bearing on the top face [N], by equation.
  Eigen::VectorXd dead_load(double vertical) const;
  static constexpr std::size_t dish = 0, socket = 1, rim = 2; ///< numbers of the contacts

private:
  StackSystem(const StackModel &model, bool with_rim, Supports supports);
  const StackModel &model_;
  bool with_rim_;
  RemoteFace top_;
};

} // namespace rimpact::fe

/// The solids of rung R2 as one system: pad (tied to the foot), foot and upper slider on the exact dish, with the
/// contacts dish-pad and cap-socket. Frame and reference position: at rest on the vertex (see stack_mesh).
#pragma once
#include "fe_contact/model/contact_steps.h"
#include "fe_contact/model/supports.h"
#include "meshes/stack_mesh.h"

namespace rimpact::fe {

class StackModel {
public:
  StackModel(const scene::Bearing &bearing, const meshes::StackMeshOptions &mesh);
  StackModel(const StackModel &) = delete;

  ContactSystem &system() { return *system_; }
  const ContactSystem &system() const { return *system_; }
  const Discretisation &space() const { return space_; }
  const Solid &solid() const { return solid_; }
  double share() const { return half_ ? 2.0 : 1.0; } ///< whole bearing over model
  /// Equation of a component of the upper slider's top face (remote displacement, no rotation); -1: held.
  int top(int component) const { return top_[component]; }
  Eigen::Vector3d top_of(const Eigen::VectorXd &by_equation) const;
  /// A vertical dead load of the whole bearing on the top face [N], by equation.
  Eigen::VectorXd dead_load(double vertical) const;
  static constexpr std::size_t dish = 0, socket = 1; ///< numbers of the contacts

private:
  bool half_;
  Discretisation space_;
  Solid solid_;
  int top_[3];
  std::optional<ContactSystem> system_;
};

} // namespace rimpact::fe

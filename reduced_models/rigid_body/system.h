/// Rigid bodies joined by unilateral contacts: forces in a configuration, with their analytic tangent
/// (thesis 3.3.2, after Bao and Becker 2019). Rotations are finite; the generalised velocity of a body is (v,
/// omega), both in space axes. Forces on a contact's body, the opposite on its master at the same point:
///   dish, interface:  -N m - mu(|v_t|) N z,   N = max(0, k d + c d'),   m the normal into the master;
///   rim, stop:        -F m, frictionless, F by the impact law.
#pragma once
#include "laws/friction/friction_law.h"
#include "laws/impact/catalogue.h"
#include "reduced_models/rigid_body/contact.h"
#include "reduced_models/rigid_body/slip.h"
#include "reduced_models/structures/superstructure.h"
#include <array>
#include <vector>

namespace rimpact::reduced::rigid {

inline constexpr int max_sets = 4, max_bodies = max_sets + max_floors, max_dofs = 6 * max_bodies;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_dofs, 1>;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_dofs, max_dofs>;
/// Of `motion`: what of a body's six entries can change, x, z and the turn about y in the plane (n = 3).
template <int n> auto entries(int body) {
  static_assert(n == 3 || n == 6);
  return Eigen::seqN(6 * body, Eigen::fix<n>, Eigen::fix<6 / n>);
}
using Poses = std::array<Pose, max_bodies>;

struct RigidBody {
  double mass;             ///< [kg]
  Eigen::Vector3d inertia; ///< principal, about the mass centre, body axes [kg m^2]
  double weight;           ///< [N]
};

/// A storey of the building the bearing carries; both bodies only translate, alike where no spring is
/// strained.
struct Link {
  Storey storey;
  int below, above; ///< bodies
};

struct NormalLaw {
  double stiffness, damping; ///< of one point [N/m], [N s/m]
};

/// What one contact does in an evaluation; `slip` is its friction state there.
struct ContactForce {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(), friction = Eigen::Vector3d::Zero(); ///< on the body [N]
  Eigen::Vector3d at = Eigen::Vector3d::Zero();                                         ///< where they act
  Eigen::Vector3d slip = Eigen::Vector3d::Zero();
  double size = 0;         ///< N or F [N]
  double penetration = 0;  ///< [m]
  double normal_power = 0; ///< taken by the contact [W]
  double slip_power = 0;   ///< taken by friction [W]
  bool passed = false;
};

/// How far a stage reaches: its derivative weights and the friction states it starts from.
struct Stage {
  double position_weight; ///< d(pose)/d(velocity) [s]
  double slip_step;       ///< of the friction state's implicit stage [s]
  const std::vector<Eigen::Vector3d> &slip;
};

class System {
public:
  std::vector<RigidBody> bodies;
  std::vector<Contact> contacts;
  std::vector<Link> links; ///< see storey_link.h
  std::vector<bool> free;  ///< of each dof; the others are at rest or driven
  bool planar = false;     ///< motion in x, z and turns about y only: tangents have no other entries
  NormalLaw normal{};
  /// Of each set of points, from the ground up. Its area is one point's share: a point goes by its own
  /// pressure.
  std::array<friction::FrictionLaw, max_sets> friction;
  std::array<double, max_sets> temperature{}; ///< of the steel of each set, as the last step left it [degrees Celsius]
  double elastic_slip = coulomb_slip;         ///< q [m]
  bool park_wen = false;
  std::array<laws::RimElement, max_sets> rim; ///< of each set: its rim, or an interface's stop
  std::vector<bool>
      unmet; ///< of each contact: without force however deep, because the step under way began before it; may be empty
  std::vector<double> deepest; ///< of each contact: penetration of its wall before this impact [m]

  int n_dofs() const { return 6 * static_cast<int>(bodies.size()); }
  /// Forces of the contacts, weights and gyroscopic moments [N], [N m]; `tangent` (may be null): the
  /// derivative by the velocities, positions following with stage.position_weight.
  Vector forces(const Poses &poses, const Vector &velocity, const Stage &stage, std::vector<ContactForce> &contact,
                Matrix *tangent) const;
  /// Of a body's entries, in space axes.
  template <int n> Eigen::Matrix<double, n, n> inertia(int body, const Poses &poses) const;
  Matrix mass_matrix(const Poses &poses) const;
  double kinetic_energy(const Poses &poses, const Vector &velocity) const;

private:
  void add(const Contact &c, const Touch &touch, const Poses &poses, const Eigen::Matrix3d &B,
           const Eigen::Vector3d &force, double position_weight, Vector &sum, Matrix *tangent) const;
  template <int n>
  void add_tangent(const Contact &c, const Eigen::Vector3d &at, const Poses &poses, const Eigen::Matrix3d &B,
                   const Eigen::Vector3d &force, double position_weight, Matrix &tangent) const;
  /// The normal force; returns its derivative by the velocity of approach, penetration following.
  double press(const Contact &c, std::size_t index, const Touch &touch, const Eigen::Vector3d &v, double weight,
               ContactForce &f) const;
  /// The friction force; `gain` as `press` returns it. Adds its derivative by the velocity to B, which may be null.
  void rub(const Contact &c, const Touch &touch, const Eigen::Vector3d &v, const Eigen::Vector3d &z0,
           const Stage &stage, double gain, ContactForce &f, Eigen::Matrix3d *B) const;
};

Eigen::Matrix3d skew(const Eigen::Vector3d &a); ///< skew(a) b = a x b

} // namespace rimpact::reduced::rigid

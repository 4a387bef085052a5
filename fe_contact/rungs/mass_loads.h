/// What acts on the supported mass while the rim is solid: everything of the reduced model but the rim.
/// Ground motion, dead load, the dish's normal force (a constraint on the speed towards the dish) and its
/// friction, in an arc's frame.
#pragma once
#include "fe_contact/engine/remote_load.h"
#include "fe_contact/rungs/rim_frame.h"
#include "io/files/choice.h"
#include "reduced_models/bearings/physical_model.h"

namespace rimpact::fe {

/// How the mass is held vertically.
enum class Support {
  dish,     ///< rides the sliding surface
  airborne, ///< lifted off
  held      ///< an isolated window: the height is held
};
constexpr auto choices(Support) {
  using enum Support;
  return choices_of<Support>({{dish, "dish"}, {airborne, "airborne"}, {held, "held"}});
}

/// Forces on the mass in the plate's frame [N].
struct MassForces {
  Eigen::Vector3d ground = Eigen::Vector3d::Zero(), weight = Eigen::Vector3d::Zero(),
                  pendular = Eigen::Vector3d::Zero(), friction = Eigen::Vector3d::Zero();
  double normal = 0; ///< N of the dish, negative when the constraint would have to pull
  Eigen::Vector3d total() const { return ground + weight + pendular + friction; }
};

class MassLoads {
public:
  MassLoads(const scene::Scene &scene, const reduced::PhysicalModel &model);

  /// Forces at a displacement u, velocity v (global), time t, for a multiplier of the vertical constraint.
  MassForces forces(const Eigen::Vector3d &u, const Eigen::Vector3d &v, double t, Support support,
                    double multiplier) const;
  /// The same as a law of an arc's top face at time t.
  RemoteLaw law(const RimFrame &frame, double t, Support support) const;
  /// Height above the sliding surface [m]; negative: sunk in.
  double height_above_dish(const Eigen::Vector3d &u) const;
  /// Upward unit normal of the surface under u.
  Eigen::Vector3d normal(const Eigen::Vector3d &u) const;
  Support initial_support() const { return held_ ? Support::held : Support::dish; }

private:
  Eigen::Vector3d constraint_gradient(const Eigen::Vector3d &u, Support support) const;

  const reduced::PhysicalModel &model_;
  double mass_, weight_;
  bool held_, friction_, ground_;
};

} // namespace rimpact::fe

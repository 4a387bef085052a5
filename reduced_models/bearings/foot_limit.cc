#include "reduced_models/bearings/foot_limit.h"
#include "reduced_models/bearings/rim_curve_file.h"
#include "scene/case_description.h"
#include <fmt/format.h>

namespace rimpact::reduced {
namespace {

/// What the law's numbers are known for.
struct Known {
  std::string joint;
  std::optional<double> force; ///< none: borne as far as they go [N]
};

Known known_of(const scene::Scene &scene) {
  const auto &r = scene.reduced;
  if (!r.impact_law->pushed) return {r.foot_joint, r.foot_force};
  const CurveJoint pushed = joint_of_curve(scene);
  return {pushed.joint, pushed.gone_at};
}

} // namespace

std::string FootLimit::sentence() const {
  return fmt::format(
      "the rim breaks off its plate: the joint at its foot, {}, goes at {:.4g} kN of the rim's force, and "
      "no law holds beyond (bearing.rim.connection)",
      joint, force / 1e3);
}

FootLimit foot_limit(const scene::Scene &scene) {
  const std::string joint = joint_at_foot(scene);
  if (joint.empty() || scene.reduced.k_i == 0) return {};
  const Known known = known_of(scene);
  FootLimit limit{.joint = joint};
  if (known.force && known.joint == joint) limit.force = *known.force;
  return limit;
}

FootLimit foot_limit(const scene::ImpactElement &element) {
  FootLimit limit{.joint = element.foot_joint};
  if (element.k_i > 0 && !limit.joint.empty() && element.foot_force) limit.force = *element.foot_force;
  return limit;
}

std::string doubt_of_foot(const scene::Scene &scene) {
  const std::string joint = joint_at_foot(scene);
  if (joint.empty()) return {};
  const std::string known = known_of(scene).joint;
  if (known == joint) return {};
  return fmt::format(
      "whether the joint at the rim's foot, {}, bears these impacts is not known: the law's numbers are {}", joint,
      known.empty() ? "of a rim in one piece with its plate, or of no finite elements" : "of " + known);
}

scene::Scene in_one_piece(scene::Scene scene) {
  scene.bearing.rim.connection = {};
  scene.reduced.forget_foot();
  return scene;
}

} // namespace rimpact::reduced

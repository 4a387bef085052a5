#include "fe_contact/rungs/mass_loads.h"

namespace rimpact::fe {
namespace {
/// Below this speed the Coulomb force is smoothed in the implicit step [m/s]; an impact passes it in
/// microseconds.
constexpr double smoothing_speed = 1e-3;
} // namespace

MassLoads::MassLoads(const scene::Scene &scene, const reduced::PhysicalModel &model)
    : model_(model), mass_(scene.load.mass), weight_(scene.load.vertical), held_(false), friction_(true),
      ground_(true) {
  if (scene.excitation.kind == scene::ExcitationKind::window) {
    held_ = !scene.excitation.with_weight;
    friction_ = scene.excitation.with_friction;
    ground_ = scene.excitation.with_ground;
  }
}

double MassLoads::height_above_dish(const Eigen::Vector3d &u) const {
  return u.z() - model_.height(u.x(), u.y()).z;
}

Eigen::Vector3d MassLoads::normal(const Eigen::Vector3d &u) const {
  return constraint_gradient(u, Support::dish).normalized();
}

Eigen::Vector3d MassLoads::constraint_gradient(const Eigen::Vector3d &u, Support support) const {
  if (support == Support::airborne) return Eigen::Vector3d::Zero();
  if (support == Support::held) return Eigen::Vector3d::UnitZ();
  const auto surface = model_.height(u.x(), u.y());
  return {-surface.gradient.x(), -surface.gradient.y(), 1.0};
}

MassForces MassLoads::forces(const Eigen::Vector3d &u, const Eigen::Vector3d &v, double t, Support support,
                             double multiplier) const {
  MassForces result;
  if (ground_) result.ground = -mass_ * model_.ground_acceleration(t);
  if (!held_) result.weight = Eigen::Vector3d(0, 0, -weight_);
  const Eigen::Vector3d gradient = constraint_gradient(u, support);
  result.pendular = multiplier * gradient;
  result.normal = multiplier * gradient.norm();
  if (friction_ && support == Support::dish)
    result.friction = model_.smoothed_friction(u, v, std::max(0.0, result.normal), smoothing_speed).force;
  return result;
}

RemoteLaw MassLoads::law(const RimFrame &frame, double t, Support support) const {
  return [this, frame, t, support](const Eigen::Vector3d &master, const Eigen::Vector3d &velocity, double multiplier) {
    const Eigen::Vector3d u = frame.displacement(master), v = frame.rate(velocity);
    const double ratio = frame.rate_ratio() / frame.reach; // of a matrix by u' on the force, by w' on the master's
    const Eigen::Matrix3d R = frame.rotation();
    RemoteLoad load;
    load.force = frame.master_force(forces(u, v, t, support, multiplier).total());
    if (support == Support::airborne) return load;
    const Eigen::Vector3d gradient = constraint_gradient(u, support);
    load.constrained = true;
    load.constraint = gradient.dot(v) / frame.dishes;
    load.gradient = frame.master_force(gradient);
    load.d_multiplier = load.gradient;
    if (support == Support::held) return load;
    Eigen::Matrix3d d_gradient = Eigen::Matrix3d::Zero();
    d_gradient.topLeftCorner<2, 2>() = -model_.height(u.x(), u.y()).hessian;
    load.by_displacement = frame.master_force(d_gradient * v);
    load.d_displacement = ratio * multiplier * R.transpose() * d_gradient * R;
    if (!friction_) return load;
    const double normal = std::max(0.0, multiplier) * gradient.norm();
    const auto friction = model_.smoothed_friction(u, v, normal, smoothing_speed);
    load.d_velocity = ratio * R.transpose() * friction.d_velocity * R;
    load.d_multiplier += frame.master_force(gradient.norm() * friction.d_normal);
    return load;
  };
}

} // namespace rimpact::fe

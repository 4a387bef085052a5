#include "reduced_models/rigid_body/system.h"
#include <Eigen/Geometry>

namespace rimpact::reduced::rigid {

using Eigen::Matrix3d, Eigen::Vector3d;

Matrix3d skew(const Vector3d &a) {
  Matrix3d s;
  s << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
  return s;
}

namespace {

Matrix3d inertia_in_space(const RigidBody &body, const Pose &pose) {
  return pose.rotation * body.inertia.asDiagonal() * pose.rotation.transpose();
}

Vector3d point_velocity(const Poses &poses, const Vector &velocity, int body, const Vector3d &at) {
  if (body == ground) return Vector3d::Zero();
  const Vector3d omega = velocity.segment<3>(6 * body + 3), arm = at - poses[body].position;
  return velocity.segment<3>(6 * body) + omega.cross(arm);
}

} // namespace

Matrix3d System::normal_terms(const Contact &c, std::size_t index, const Touch &touch, const Vector3d &v, double weight,
                              ContactForce &f) const {
  const Vector3d &m = touch.normal;
  const double d = touch.penetration, rate = m.dot(v);
  double stiffness = 0, damping = 0;
  if (!is_wall(c.surface)) {
    const double trial = normal.stiffness * d + normal.damping * rate;
    if (d > 0 && trial > 0) f.size = trial, stiffness = normal.stiffness, damping = normal.damping;
  } else if (d > 0 && !touch.passed && rim.stiffness > 0) {
    const auto law = rim.at({d, rate, v.norm(), deepest[index]});
    if (!rim.law->unilateral || law.force > 0) f.size = law.force, stiffness = law.d_penetration, damping = law.d_rate;
  }
  f.normal = -f.size * m;
  f.normal_power = f.size * rate;
  const Matrix3d across = m * m.transpose();
  return -(damping + weight * stiffness) * across - weight * f.size * touch.curvature * (Matrix3d::Identity() - across);
}

void System::friction_terms(const Contact &c, const Touch &touch, const Vector3d &v, const Vector3d &z0,
                            const Stage &stage, ContactForce &f, Matrix3d &B) const {
  const Matrix3d along = Matrix3d::Identity() - touch.normal * touch.normal.transpose();
  const Vector3d slide = along * v;
  const double speed = slide.norm(), per_slip = stage.slip_step / elastic_slip;
  const auto &law = c.surface != Surface::dish ? interface_friction : c.set == 2 ? top_friction : dish_friction;
  const auto mu = law.at(speed);
  const auto state = park_wen ? park_wen_step(along * z0, slide, per_slip) : coulomb_step(along * z0, slide, per_slip);
  f.slip = state.z;
  f.friction = -mu.value * f.size * state.z;
  f.slip_power = -f.friction.dot(slide);
  // d N / d v = -m^T B of the normal part alone
  const Eigen::RowVector3d d_size = -touch.normal.transpose() * B;
  B -= mu.value * state.z * d_size + mu.value * f.size * state.d_velocity * along;
  if (speed > 0 && mu.slope != 0) B -= f.size * mu.slope / speed * state.z * slide.transpose();
}

void System::add(const Contact &c, const Touch &touch, const Poses &poses, const Matrix3d &B, const Vector3d &force,
                 double position_weight, Vector &sum, Matrix *tangent) const {
  struct Side {
    int body;
    double sign;
    Vector3d arm;
    Matrix3d lever, B_lever; ///< skew(arm), B skew(arm)
  };
  const auto side = [&](int body, double sign) {
    if (body == ground) return Side{body, sign, {}, {}, {}};
    const Vector3d arm = touch.at - poses[body].position;
    const Matrix3d lever = skew(arm);
    return Side{body, sign, arm, lever, tangent ? Matrix3d(B * lever) : Matrix3d()};
  };
  const Side sides[] = {side(c.body, 1.0), side(c.master, -1.0)};
  const Matrix3d twist = skew(force);
  for (const auto &row : sides) {
    if (row.body == ground) continue;
    sum.segment<3>(6 * row.body) += row.sign * force;
    sum.segment<3>(6 * row.body + 3) += row.sign * row.arm.cross(force);
    if (!tangent) continue;
    const Matrix3d lever_B = row.lever * B;
    for (const auto &column : sides) {
      if (column.body == ground) continue;
      const double sign = row.sign * column.sign;
      auto block = tangent->block<6, 6>(6 * row.body, 6 * column.body);
      block.topLeftCorner<3, 3>() += sign * B;
      block.topRightCorner<3, 3>() -= sign * column.B_lever;
      block.bottomLeftCorner<3, 3>() += sign * lever_B;
      block.bottomRightCorner<3, 3>() -= sign * (row.lever * column.B_lever);
    }
    // The arm follows the point of the body: d(at) = dr + dtheta x arm of the body, less its own origin.
    const Matrix3d F = position_weight * row.sign * twist;
    tangent->block<3, 3>(6 * row.body + 3, 6 * c.body) -= F;
    tangent->block<3, 3>(6 * row.body + 3, 6 * c.body + 3) += F * sides[0].lever;
    tangent->block<3, 3>(6 * row.body + 3, 6 * row.body) += F;
  }
}

Vector System::forces(const Poses &poses, const Vector &velocity, const Stage &stage,
                      std::vector<ContactForce> &contact, Matrix *tangent) const {
  static const Pose at_rest;
  Vector sum = Vector::Zero(n_dofs());
  if (tangent) tangent->setZero(n_dofs(), n_dofs());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    sum[6 * i + 2] = -bodies[i].weight;
    const Vector3d omega = velocity.segment<3>(6 * i + 3);
    sum.segment<3>(6 * i + 3) -= omega.cross(inertia_in_space(bodies[i], poses[i]) * omega);
  }
  contact.resize(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact &c = contacts[i];
    ContactForce &f = contact[i] = {};
    const Touch touch = locate(c, poses[c.body], c.master == ground ? at_rest : poses[c.master]);
    f.at = touch.at, f.penetration = touch.penetration, f.passed = touch.passed;
    f.slip = stage.slip[i];
    if (touch.penetration <= 0 || (!unmet.empty() && unmet[i])) continue;
    const Vector3d v =
        point_velocity(poses, velocity, c.body, touch.at) - point_velocity(poses, velocity, c.master, touch.at);
    Matrix3d B = normal_terms(c, i, touch, v, stage.position_weight, f);
    if (f.size == 0) continue;
    if (!is_wall(c.surface)) friction_terms(c, touch, v, stage.slip[i], stage, f, B);
    add(c, touch, poses, B, f.normal + f.friction, stage.position_weight, sum, tangent);
  }
  return sum;
}

Matrix System::mass_matrix(const Poses &poses) const {
  Matrix M = Matrix::Zero(n_dofs(), n_dofs());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    M.block<3, 3>(6 * i, 6 * i) = bodies[i].mass * Matrix3d::Identity();
    M.block<3, 3>(6 * i + 3, 6 * i + 3) = inertia_in_space(bodies[i], poses[i]);
  }
  return M;
}

double System::kinetic_energy(const Poses &poses, const Vector &velocity) const {
  return 0.5 * velocity.dot(mass_matrix(poses) * velocity);
}

} // namespace rimpact::reduced::rigid

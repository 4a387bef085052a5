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

double System::press(const Contact &c, std::size_t index, const Touch &touch, const Vector3d &v, double weight,
                     ContactForce &f) const {
  const double d = touch.penetration, rate = touch.normal.dot(v);
  const laws::RimElement &element = rim[c.set];
  double stiffness = 0, damping = 0;
  if (!is_wall(c.surface)) {
    const double trial = normal.stiffness * d + normal.damping * rate;
    if (d > 0 && trial > 0) f.size = trial, stiffness = normal.stiffness, damping = normal.damping;
  } else if (d > 0 && !touch.passed && element.stiffness > 0) {
    const auto law = element.at({d, rate, v.norm(), deepest[index]});
    if (!element.law->unilateral || law.force > 0)
      f.size = law.force, stiffness = law.d_penetration, damping = law.d_rate;
  }
  f.normal = -f.size * touch.normal;
  f.normal_power = f.size * rate;
  return damping + weight * stiffness;
}

void System::rub(const Contact &c, const Touch &touch, const Vector3d &v, const Vector3d &z0, const Stage &stage,
                 double gain, ContactForce &f, Matrix3d *B) const {
  const Vector3d &m = touch.normal;
  const Vector3d slide = v - m * m.dot(v), start = z0 - m * m.dot(z0);
  const double speed = slide.norm(), per_slip = stage.slip_step / elastic_slip;
  const auto &law = friction[c.set];
  const auto mu = law.under(f.size, speed, temperature[c.set]);
  const auto state = park_wen ? park_wen_step(start, slide, per_slip) : coulomb_step(start, slide, per_slip);
  f.slip = state.z;
  f.friction = -mu.value * f.size * state.z;
  f.slip_power = -f.friction.dot(slide);
  if (!B) return;
  Vector3d by_z = law.d_force(mu, f.size) * gain * m; // of -F / z by the velocity
  if (speed > 0 && mu.d_speed != 0) by_z += f.size * mu.d_speed / speed * slide;
  const Vector3d across = state.d_velocity * m;
  *B -= state.z * by_z.transpose() + mu.value * f.size * (state.d_velocity - across * m.transpose());
}

namespace {

/// Velocity of a body's point at `arm` by the body's entries: x, z and the turn about y in the plane, all six in space.
template <int n> Eigen::Matrix<double, 3, n> point_motion(const Vector3d &arm) {
  Eigen::Matrix<double, 3, n> motion;
  if constexpr (n == 6)
    motion << Matrix3d::Identity(), -skew(arm);
  else
    motion << 1, 0, arm[2], 0, 0, 0, 0, 1, -arm[0];
  return motion;
}

} // namespace

template <int n>
void System::add_tangent(const Contact &c, const Vector3d &at, const Poses &poses, const Matrix3d &B,
                         const Vector3d &force, double position_weight, Matrix &tangent) const {
  constexpr int first_turn = n / 2 + n % 2, turns = n - first_turn; // of a body's entries: x y z, or x z
  struct Side {
    int body;
    double sign;
    Eigen::Matrix<double, 3, n> motion;
  };
  const auto side = [&](int body, double sign) {
    return body == ground ? Side{body, sign, {}} : Side{body, sign, point_motion<n>(at - poses[body].position)};
  };
  const Side sides[] = {side(c.body, 1.0), side(c.master, -1.0)};
  const Matrix3d twist = skew(force);
  for (const auto &row : sides) {
    if (row.body == ground) continue;
    // The arm follows the point of the body: d(at) = dr + dtheta x arm of the body, less its own origin.
    const Eigen::Matrix<double, turns, 3> F = position_weight * row.sign * twist.middleRows<turns>(n == 6 ? 0 : 1);
    for (const auto &column : sides) {
      if (column.body == ground) continue;
      Eigen::Matrix<double, n, n> K = row.sign * column.sign * row.motion.transpose() * (B * column.motion);
      if (&column == sides) K.template bottomRows<turns>() -= F * column.motion;
      if (&column == &row)
        for (int i = 0; i < first_turn; ++i) K.col(i).template tail<turns>() += F.col(i * (6 / n));
      tangent(entries<n>(row.body), entries<n>(column.body)) += K;
    }
  }
}

void System::add(const Contact &c, const Touch &touch, const Poses &poses, const Matrix3d &B, const Vector3d &force,
                 double position_weight, Vector &sum, Matrix *tangent) const {
  const auto push = [&](int body, const Vector3d &f) {
    sum.segment<3>(6 * body) += f;
    sum.segment<3>(6 * body + 3) += (touch.at - poses[body].position).cross(f);
  };
  push(c.body, force);
  if (c.master != ground) push(c.master, -force);
  if (!tangent) return;
  if (planar)
    add_tangent<3>(c, touch.at, poses, B, force, position_weight, *tangent);
  else
    add_tangent<6>(c, touch.at, poses, B, force, position_weight, *tangent);
}

Vector System::forces(const Poses &poses, const Vector &velocity, const Stage &stage,
                      std::vector<ContactForce> &contact, Matrix *tangent) const {
  static const Pose at_rest;
  Vector sum = Vector::Zero(n_dofs());
  if (tangent) tangent->setZero(n_dofs(), n_dofs());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    sum[6 * i + 2] = -bodies[i].weight;
    const Vector3d omega = velocity.segment<3>(6 * i + 3);
    if (!planar) sum.segment<3>(6 * i + 3) -= omega.cross(inertia_in_space(bodies[i], poses[i]) * omega);
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
    const double gain = press(c, i, touch, v, stage.position_weight, f);
    if (f.size == 0) continue;
    Matrix3d B;
    if (tangent) {
      const double turning = stage.position_weight * f.size * touch.curvature;
      B = (turning - gain) * touch.normal * touch.normal.transpose();
      B.diagonal().array() -= turning;
    }
    if (!is_wall(c.surface)) rub(c, touch, v, stage.slip[i], stage, gain, f, tangent ? &B : nullptr);
    add(c, touch, poses, B, f.normal + f.friction, stage.position_weight, sum, tangent);
  }
  return sum;
}

template <int n> Eigen::Matrix<double, n, n> System::inertia(int body, const Poses &poses) const {
  const RigidBody &b = bodies[body];
  Eigen::Matrix<double, n, n> M = b.mass * Eigen::Matrix<double, n, n>::Identity();
  if constexpr (n == 3)
    M(2, 2) = b.inertia[1];
  else
    M.template bottomRightCorner<3, 3>() = inertia_in_space(b, poses[body]);
  return M;
}
template Eigen::Matrix<double, 3, 3> System::inertia<3>(int body, const Poses &poses) const;
template Eigen::Matrix<double, 6, 6> System::inertia<6>(int body, const Poses &poses) const;

Matrix System::mass_matrix(const Poses &poses) const {
  Matrix M = Matrix::Zero(n_dofs(), n_dofs());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    M.block<3, 3>(6 * i, 6 * i) = bodies[i].mass * Matrix3d::Identity();
    M.block<3, 3>(6 * i + 3, 6 * i + 3) = inertia_in_space(bodies[i], poses[i]);
  }
  return M;
}

double System::kinetic_energy(const Poses &poses, const Vector &velocity) const {
  double twice = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Vector3d omega = velocity.segment<3>(6 * i + 3);
    twice += bodies[i].mass * velocity.segment<3>(6 * i).squaredNorm() +
             omega.dot(inertia_in_space(bodies[i], poses[i]) * omega);
  }
  return twice / 2;
}

} // namespace rimpact::reduced::rigid

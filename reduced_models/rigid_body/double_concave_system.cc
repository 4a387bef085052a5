#include "reduced_models/rigid_body/double_concave_system.h"
#include <algorithm>
#include <Eigen/Geometry>

namespace rimpact::reduced::rigid {

using Eigen::Vector2d, Eigen::Vector3d;

double contact_damping(const scene::DoubleConcave &b, double supported_mass, int n_sets) {
  const bool own = b.damped_mass == scene::DampedMass::bearing;
  const double mass = own ? b.own_reduced_mass() : supported_mass * n_sets / b.points;
  return 2 * laws::damping_ratio(b.contact_restitution) * std::sqrt(b.contact_stiffness * mass);
}

MotionState DoubleConcaveSystem::state_at(const Vector2d &u, const Vector2d &v) const {
  const auto &b = bearing_;
  const double R_eff = b.effective_radius(), H = b.slider_height();
  Vector3d axis(-u[0] / R_eff, -u[1] / R_eff, 0);
  axis[2] = std::sqrt(1 - axis.squaredNorm());
  const Vector3d velocity(v[0], v[1], -v.dot(axis.head<2>()) / axis[2]);
  const Vector3d omega = -axis.cross(velocity) / R_eff, centre(0, 0, b.radius), up = Vector3d::UnitZ();
  MotionState s;
  s.velocity = Vector::Zero(system.n_dofs());
  const auto rotation = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), axis).toRotationMatrix();
  // Under the weights the springs of each set give way: from the static penetration nothing rings.
  double weight = 0, sunk[3] = {};
  for (int body = plate; body >= 0; --body) weight += system.bodies[body].weight, sunk[body] = weight;
  const double spring = b.points * b.contact_stiffness;
  double below = 0;
  for (int body = 0; body <= plate; ++body) {
    const bool plane = resilient_ && body == 1;
    const double cosine = std::cos(body == plate ? b.top_edge_angle() : b.edge_angle());
    below += sunk[body] / spring / (plane ? 1 : cosine * cosine);
    const double height = !resilient_ ? H / 2 : body == 0 ? b.bottom_height / 2 : H - b.top_height / 2;
    const Vector3d from_vertex =
        body == plate ? Vector3d(H * axis + b.upper_radius() * (up - axis)) : Vector3d(height * axis);
    s.poses[body].position = centre - b.radius * axis + from_vertex - Vector3d(0, 0, below);
    if (body != plate) s.poses[body].rotation = rotation;
    s.velocity.segment<3>(6 * body) = body == plate ? velocity : omega.cross(s.poses[body].position - centre);
    if (body != plate) s.velocity.segment<3>(6 * body + 3) = omega;
  }
  for (int i = 1; i <= building.n_floors(); ++i) {
    s.poses[plate + i].position = s.poses[plate].position;
    s.velocity.segment<3>(6 * (plate + i)) = velocity;
  }
  return s;
}

Vector3d DoubleConcaveSystem::plate_displacement(const MotionState &s) const {
  return s.poses[plate].position - Vector3d(0, 0, bearing_.slider_height());
}

BuildingSnapshot DoubleConcaveSystem::building_at(const MotionState &s) const {
  const auto motion = [&](int body) { return FloorMotion{s.poses[body].position, s.velocity.segment<3>(6 * body)}; };
  std::array<FloorMotion, max_floors> floors;
  for (int i = 0; i < building.n_floors(); ++i) floors[i] = motion(plate + 1 + i);
  return snapshot(building, motion(plate), floors.data(), s.z.data());
}

Vector3d DoubleConcaveSystem::interface_slip(const MotionState &s) const {
  if (!resilient_) return Vector3d::Zero();
  const Vector3d up = s.poses[0].rotation.col(2);
  const Vector3d apart =
      s.poses[1].at({0, 0, -bearing_.top_height / 2}) - s.poses[0].at({0, 0, bearing_.bottom_height / 2});
  return apart - up * up.dot(apart);
}

double DoubleConcaveSystem::tilt(const MotionState &s) const {
  const Vector3d up = s.poses[0].rotation.col(2);
  return std::atan2(std::hypot(up[0], up[1]), up[2]);
}

double DoubleConcaveSystem::gap(const MotionState &s) const {
  return bearing_.lateral_capacity() - (plate_displacement(s) - interface_slip(s)).head<2>().norm();
}

double DoubleConcaveSystem::potential_energy(const MotionState &s) const {
  double energy = 0;
  for (int body = 0; body <= plate; ++body) energy += system.bodies[body].weight * s.poses[body].position[2];
  return energy;
}

double DoubleConcaveSystem::stored_energy(const MotionState &s) const {
  double energy = 0;
  for (std::size_t i = 0; i < s.contact.size(); ++i) {
    const double d = std::max(0.0, s.contact[i].penetration);
    if (!is_wall(system.contacts[i].surface)) energy += system.normal.stiffness / 2 * d * d;
  }
  return energy;
}

const char *DoubleConcaveSystem::lost(const MotionState &s) const {
  for (std::size_t i = 0; i < s.contact.size(); ++i)
    if (s.contact[i].passed)
      return system.contacts[i].surface == Surface::rim ? "the slider has left over a rim"
                                                        : "the top slider has left over the stop";
  // Past the angle at which its diagonal stands upright a block does not come back.
  const double limit = std::atan2(bearing_.slider_diameter, bearing_.slider_height()) + bearing_.rim_tilt();
  for (int body = 0; body < plate; ++body)
    if (s.poses[body].rotation(2, 2) < std::cos(std::min(limit, 1.5))) return "the slider has overturned";
  return nullptr;
}

} // namespace rimpact::reduced::rigid

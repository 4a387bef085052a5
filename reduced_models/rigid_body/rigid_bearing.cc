#include "reduced_models/rigid_body/rigid_bearing.h"
#include "reduced_models/rigid_body/bearing_contacts.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Geometry>

namespace rimpact::reduced::rigid {

using Eigen::Vector2d, Eigen::Vector3d;

double contact_damping(const scene::Isolator &b, double supported_mass, int n_sets) {
  const bool own = b.damped_mass == scene::DampedMass::bearing;
  const double mass = own ? b.own_reduced_mass() : supported_mass * n_sets / b.points;
  return 2 * laws::damping_ratio(b.contact_restitution) * std::sqrt(b.contact_stiffness * mass);
}

namespace {

RigidBody cylinder(const Slider &s, double gravity) {
  const double across = s.mass * (s.diameter * s.diameter / 16 + s.height * s.height / 12);
  return {s.mass, {across, across, s.mass * s.diameter * s.diameter / 8}, s.mass * gravity};
}

} // namespace

RigidBearing::RigidBearing(const scene::Scene &scene)
    : driven(!scene.excitation.is_dynamic()), parts(parts_of(scene, driven)),
      plate(static_cast<int>(parts.sliders.size())), building(scene), bearing_(scene.isolator),
      capacity_(scene.lateral_capacity()) {
  const auto &r = scene.reduced;
  const int n_sets = static_cast<int>(parts.joints.size());
  add_bodies(scene);
  system.contacts = contacts_of(parts, bearing_);
  system.deepest.assign(system.contacts.size(), 0.0);
  system.normal = {bearing_.contact_stiffness, contact_damping(bearing_, scene.load.mass, n_sets)};
  for (int j = 0; j < n_sets; ++j) {
    const Joint &joint = parts.joints[j];
    const scene::ImpactElement &element = element_of(scene, joint);
    system.friction[j] = joint.friction;
    if (element.k_i > 0) system.rim[j] = element.element(joint.rim_mass);
    if (driven) system.rim[j].damping = 0;
    const FootLimit limit = foot_limit(element);
    foot_[j] = {limit, limit.is_known() ? limit.sentence() : ""};
  }
  system.park_wen = r.friction == scene::Friction::park_wen && !driven;
  if (system.park_wen) system.elastic_slip = r.elastic_slip;
}

void RigidBearing::add_bodies(const scene::Scene &scene) {
  const auto &b = bearing_;
  for (const auto &slider : parts.sliders) system.bodies.push_back(cylinder(slider, scene.load.gravity));
  const double J = b.plate_inertia;
  system.bodies.push_back({scene.load.mass - building.mass(), {J, J, J}, scene.load.vertical});
  const bool planar = system.planar = b.space == scene::Space::planar,
             plate_turns = b.plate_rotation == scene::PlateRotation::free;
  for (int body = 0; body <= plate; ++body)
    for (int dof = 0; dof < 6; ++dof) {
      const bool in_plane = dof == 0 || dof == 2 || dof == 4, turns = dof >= 3;
      system.free.push_back((!planar || in_plane) &&
                            (body != plate || ((!turns || plate_turns) && (!driven || dof > 1))));
    }
  // The dead load of the floors is the plate's: axial springs know changes from it only.
  for (int i = 0; i < building.n_floors(); ++i) {
    system.bodies.push_back({building.storeys[i].mass, {1, 1, 1}, 0.0});
    system.links.push_back({building.storeys[i], plate + i, plate + i + 1});
    for (int dof = 0; dof < 6; ++dof) system.free.push_back(dof < 3 && (!planar || dof != 1));
  }
}

MotionState RigidBearing::state_at(const Vector2d &u, const Vector2d &v) const {
  const double R_eff = bearing_.effective_radius(), R = bearing_.radius;
  Vector3d axis(-u[0] / R_eff, -u[1] / R_eff, 0);
  axis[2] = std::sqrt(1 - axis.squaredNorm());
  const Vector3d velocity(v[0], v[1], -v.dot(axis.head<2>()) / axis[2]);
  const Vector3d omega = -axis.cross(velocity) / R_eff, centre(0, 0, R), up = Vector3d::UnitZ();
  MotionState s;
  s.velocity = Vector::Zero(system.n_dofs());
  const auto rotation = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), axis).toRotationMatrix();
  // Under the weights the springs of each set give way: from the static penetration nothing rings.
  double weight = 0, sunk[max_sets] = {};
  for (int body = plate; body >= 0; --body) weight += system.bodies[body].weight, sunk[body] = weight;
  const double spring = bearing_.points * bearing_.contact_stiffness;
  double lowered = 0, height = 0; // height: of a body's lower face over the bottom plate's vertex, along the axis
  for (int body = 0; body <= plate; ++body) {
    const Joint &j = parts.joints[body];
    const double sine = j.surface == Surface::dish ? j.half / j.radius : 0;
    lowered += sunk[body] / spring / (1 - sine * sine);
    const double R_top = bearing_.upper_radius();
    const bool uppermost = body > 0 && body + 1 == plate; // measured from the top plate
    const double half = body == plate ? 0 : parts.sliders[body].height / 2,
                 middle = uppermost ? bearing_.slider_height() - half : height + half;
    const Vector3d from_vertex =
        body == plate ? Vector3d(height * axis + R_top * (up - axis)) : Vector3d(middle * axis);
    s.poses[body].position = centre - R * axis + from_vertex - Vector3d(0, 0, lowered);
    s.velocity.segment<3>(6 * body) = body == plate ? velocity : omega.cross(s.poses[body].position - centre);
    if (body == plate) break;
    s.poses[body].rotation = rotation;
    s.velocity.segment<3>(6 * body + 3) = omega;
    height += parts.sliders[body].height;
  }
  for (int i = 1; i <= building.n_floors(); ++i) {
    s.poses[plate + i].position = s.poses[plate].position;
    s.velocity.segment<3>(6 * (plate + i)) = velocity;
  }
  return s;
}

Vector3d RigidBearing::plate_displacement(const MotionState &s) const {
  return s.poses[plate].position - Vector3d(0, 0, bearing_.slider_height());
}

BuildingSnapshot RigidBearing::building_at(const MotionState &s) const {
  const auto motion = [&](int body) { return FloorMotion{s.poses[body].position, s.velocity.segment<3>(6 * body)}; };
  std::array<FloorMotion, max_floors> floors;
  for (int i = 0; i < building.n_floors(); ++i) floors[i] = motion(plate + 1 + i);
  return snapshot(building, motion(plate), floors.data(), s.z.data());
}

Vector3d RigidBearing::interface_slip(const MotionState &s) const {
  Vector3d slip = Vector3d::Zero();
  for (int j = 1; j < plate; ++j) {
    if (parts.joints[j].surface != Surface::interface) continue;
    const Vector3d up = s.poses[j - 1].rotation.col(2);
    const Vector3d apart =
        s.poses[j].at({0, 0, parts.face_below(j)}) - s.poses[j - 1].at({0, 0, parts.face_above(j - 1)});
    slip = apart - up * up.dot(apart);
  }
  return slip;
}

Vector2d RigidBearing::travel(const MotionState &s, int joint) const {
  const Joint &j = parts.joints[joint];
  const auto axis = [&](int body) {
    return body == ground ? Vector3d(0, 0, 1) : Vector3d(s.poses[body].rotation.col(2));
  };
  const Vector3d turn = j.points_above ? axis(joint - 1) - axis(joint) : axis(joint) - axis(joint - 1);
  return j.effective_radius * turn.head<2>();
}

double RigidBearing::tilt(const MotionState &s) const {
  const Vector3d up = s.poses[0].rotation.col(2);
  return std::atan2(std::hypot(up[0], up[1]), up[2]);
}

double RigidBearing::gap(const MotionState &s) const {
  return capacity_ - (plate_displacement(s) - interface_slip(s)).head<2>().norm();
}

double RigidBearing::potential_energy(const MotionState &s) const {
  double energy = 0;
  for (int body = 0; body <= plate; ++body) energy += system.bodies[body].weight * s.poses[body].position[2];
  return energy;
}

double RigidBearing::stored_energy(const MotionState &s) const {
  double energy = 0;
  for (std::size_t i = 0; i < s.contact.size(); ++i) {
    const double d = std::max(0.0, s.contact[i].penetration);
    if (!is_wall(system.contacts[i].surface)) energy += system.normal.stiffness / 2 * d * d;
  }
  return energy;
}

/// By the force of all the points that press one rim.
const RigidBearing::Foot *RigidBearing::broken_foot(const MotionState &s) const {
  if (std::none_of(foot_.begin(), foot_.end(), [](const Foot &foot) { return foot.limit.is_known(); })) return nullptr;
  std::array<Vector3d, max_sets> force;
  force.fill(Vector3d::Zero());
  for (std::size_t i = 0; i < s.contact.size(); ++i)
    if (system.contacts[i].surface == Surface::rim) force[system.contacts[i].set] += s.contact[i].normal;
  for (int j = 0; j < max_sets; ++j)
    if (foot_[j].limit.gone(force[j].norm())) return &foot_[j];
  return nullptr;
}

const char *RigidBearing::lost(const MotionState &s) const {
  for (std::size_t i = 0; i < s.contact.size(); ++i)
    if (s.contact[i].passed)
      return system.contacts[i].surface == Surface::rim ? "the slider has left over a rim"
                                                        : "the top slider has left over the stop";
  if (const Foot *foot = broken_foot(s)) return foot->gone.c_str();
  // Past the angle at which the diagonal of all sliders stands upright a block does not come back.
  double rims = 0;
  for (int body = 0; body < plate; ++body) {
    rims += parts.joints[body].tilt;
    const double limit = std::atan2(parts.sliders[body].diameter, bearing_.slider_height()) + rims;
    if (s.poses[body].rotation(2, 2) < std::cos(std::min(limit, 1.5))) return "the slider has overturned";
  }
  return nullptr;
}

} // namespace rimpact::reduced::rigid

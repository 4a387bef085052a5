// What a double concave bearing is made of: bodies, contact points, walls.
#include "reduced_models/rigid_body/double_concave_system.h"
#include <numbers>

namespace rimpact::reduced::rigid {

using Eigen::Vector2d, Eigen::Vector3d;

namespace {

RigidBody cylinder(double mass, double diameter, double height, double gravity) {
  const double across = mass * (diameter * diameter / 16 + height * height / 12);
  return {mass, {across, across, mass * diameter * diameter / 8}, mass * gravity};
}

/// Where the contact points of a set lie in its plane: on a line (planar) or a circle (spatial).
std::vector<Vector2d> layout(const scene::DoubleConcave &b, double radius) {
  std::vector<Vector2d> points;
  for (int i = 0; i < b.points; ++i) {
    const double angle = 2 * std::numbers::pi * i / b.points;
    points.push_back(b.space == scene::Space::planar ? Vector2d(radius * (2.0 * i / (b.points - 1) - 1), 0)
                                                     : Vector2d(radius * std::cos(angle), radius * std::sin(angle)));
  }
  return points;
}

/// The mass whose impact on one rim returns e. A rim is penetrated by about R / (R_1 + R_2) of the travel beyond its
/// capacity, so the bearing has that share's square of its k and c, summed over the rims that are touched together, and
/// must return e: c is that of this many supported masses (2 where the plates are alike).
double mass_before_rim(const scene::DoubleConcave &b, double supported_mass) {
  if (b.damped_mass == scene::DampedMass::bearing) return b.own_reduced_mass();
  const double R[] = {b.radius, b.upper_radius()}, C[] = {b.capacity, b.upper_capacity()}, both = R[0] + R[1];
  double squares = 0;
  for (int i = 0; i < 2; ++i)
    if (C[i] <= b.lateral_capacity()) squares += R[i] * R[i];
  return supported_mass * both * both / squares;
}

double depth(double R, double r) {
  return R - std::sqrt(R * R - r * r);
}

} // namespace

DoubleConcaveSystem::DoubleConcaveSystem(const scene::Scene &scene)
    : plate(scene.impact_resilient() ? 2 : 1), top_slider(plate - 1), driven(!scene.excitation.is_dynamic()),
      building(scene), bearing_(scene.isolator), resilient_(scene.impact_resilient()), n_sets_(resilient_ ? 3 : 2) {
  const auto &r = scene.reduced;
  add_bodies(scene);
  add_points(bearing_);
  add_walls(bearing_);
  system.deepest.assign(system.contacts.size(), 0.0);
  system.normal = {bearing_.contact_stiffness, contact_damping(bearing_, scene.load.mass, n_sets_)};
  const double fast = driven ? r.mu_slow : r.mu_fast; // slow motion
  const double top_fast = bearing_.top_mu_fast.value_or(r.mu_fast),
               top_slow = bearing_.top_mu_slow.value_or(bearing_.top_mu_fast ? top_fast : r.mu_slow);
  system.friction[0] = scene::sliding_law(scene, r.mu_slow, fast);
  system.friction[2] = scene::sliding_law(scene, top_slow, driven ? top_slow : top_fast);
  system.friction[1] = {.mu_slow = bearing_.mu_interface, .mu_fast = bearing_.mu_interface, .scale = r.measured.scale};
  for (auto &law : system.friction) law.area /= bearing_.points;
  system.park_wen = r.friction == scene::Friction::park_wen && !driven;
  if (system.park_wen) system.elastic_slip = r.elastic_slip;
  if (r.k_i > 0) system.rim = r.element(mass_before_rim(bearing_, scene.load.mass));
  if (driven) system.rim.damping = 0;
}

void DoubleConcaveSystem::add_bodies(const scene::Scene &scene) {
  const auto &b = bearing_;
  const double g = scene.load.gravity, H = b.slider_height();
  if (resilient_) {
    system.bodies.push_back(cylinder(b.slider_mass * b.bottom_height / H, b.slider_diameter, b.bottom_height, g));
    system.bodies.push_back(cylinder(b.slider_mass * b.top_height / H, b.slider_diameter, b.top_height, g));
  } else {
    system.bodies.push_back(cylinder(b.slider_mass, b.slider_diameter, H, g));
  }
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

void DoubleConcaveSystem::add_points(const scene::DoubleConcave &b) {
  const double R = b.radius, R_top = b.upper_radius(), H = b.slider_height();
  const double bottom = (resilient_ ? b.bottom_height : H) / 2, top = (resilient_ ? b.top_height : H) / 2;
  for (const auto &p : layout(b, b.slider_diameter / 2))
    system.contacts.push_back({.surface = Surface::dish,
                               .body = 0,
                               .master = ground,
                               .point = {p[0], p[1], depth(R, p.norm()) - bottom},
                               .centre = {0, 0, R},
                               .radius = R});
  if (resilient_)
    for (const auto &p : layout(b, b.slider_diameter / 2 - b.top_wall))
      system.contacts.push_back({.surface = Surface::interface,
                                 .body = 1,
                                 .master = 0,
                                 .point = {p[0], p[1], -top},
                                 .centre = {0, 0, bottom},
                                 .set = 1});
  for (const auto &p : layout(b, b.slider_diameter / 2))
    system.contacts.push_back({.surface = Surface::dish,
                               .body = top_slider,
                               .master = plate,
                               .point = {p[0], p[1], top - depth(R_top, p.norm())},
                               .centre = {0, 0, -R_top},
                               .radius = R_top,
                               .set = 2});
}

void DoubleConcaveSystem::add_walls(const scene::DoubleConcave &b) {
  const double R = b.radius, R_top = b.upper_radius(), H = b.slider_height(), half = b.slider_diameter / 2;
  const double bottom = (resilient_ ? b.bottom_height : H) / 2, top = (resilient_ ? b.top_height : H) / 2;
  const double wall = b.bottom_rim_radius(), top_wall = b.top_rim_radius();
  const auto add = [&](const Vector2d &at, double reach) {
    system.contacts.push_back({.surface = Surface::rim,
                               .body = 0,
                               .master = ground,
                               .point = {at[0], at[1], depth(R, half) - bottom},
                               .centre = {0, 0, depth(R, wall)},
                               .radius = wall,
                               .reach = reach,
                               .wall_height = b.rim_height});
    system.contacts.push_back({.surface = Surface::rim,
                               .body = top_slider,
                               .master = plate,
                               .point = {at[0], at[1], top - depth(R_top, half)},
                               .centre = {0, 0, -depth(R_top, top_wall)},
                               .radius = top_wall,
                               .reach = reach,
                               .wall_height = b.rim_height,
                               .upward = -1,
                               .set = 2});
  };
  if (b.space == scene::Space::planar)
    add({-half, 0}, 0), add({half, 0}, 0);
  else if (b.rim == scene::RimTouch::circle)
    add({0, 0}, half);
  else
    for (const auto &p : layout(b, half)) add(p, 0);
  if (resilient_)
    system.contacts.push_back({.surface = Surface::stop,
                               .body = 1,
                               .master = 0,
                               .point = {0, 0, -top},
                               .centre = {0, 0, bottom},
                               .radius = b.gap(),
                               .reach = half - b.top_wall,
                               .wall_height = b.stop_height,
                               .set = 1});
}

} // namespace rimpact::reduced::rigid

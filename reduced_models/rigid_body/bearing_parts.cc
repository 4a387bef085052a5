#include "reduced_models/rigid_body/bearing_parts.h"
#include "reduced_models/rigid_body/triple_parts.h"
#include "scene/face_friction.h"
#include <cmath>
#include <numbers>

namespace rimpact::reduced::rigid {

using Eigen::Vector2d;

namespace {

/// The mass whose impact on one rim returns e. A rim is penetrated by about R / (R_1 + R_2) of the travel beyond its
/// capacity, so the bearing has that share's square of its k and c, summed over the rims that are touched together, and
/// must return e: c is that of this many supported masses (2 where the plates are alike).
double mass_before_rim(const scene::Isolator &b, double supported_mass) {
  if (b.damped_mass == scene::DampedMass::bearing) return b.own_reduced_mass();
  const double R[] = {b.radius, b.upper_radius()}, C[] = {b.capacity, b.upper_capacity()}, both = R[0] + R[1];
  double squares = 0;
  for (int i = 0; i < 2; ++i)
    if (C[i] <= b.lateral_capacity()) squares += R[i] * R[i];
  return supported_mass * both * both / squares;
}

Joint dish(const scene::Scene &scene, bool below, bool slow) {
  const auto &b = scene.isolator;
  Joint j{.points_above = below, .half = b.slider_diameter / 2, .wall_height = b.rim_height};
  j.radius = below ? b.radius : b.upper_radius(), j.wall = below ? b.bottom_rim_radius() : b.top_rim_radius();
  j.name = below ? 'B' : 'A', j.tilt = b.rim_tilt(), j.face = scene::contact_radius(scene);
  const auto faces = scene::face_coefficients(scene);
  const auto &mu = below ? faces.front() : faces.back();
  j.friction = scene::sliding_law(scene, mu.slow, slow ? mu.slow : mu.fast);
  return j;
}

Joint interface(const scene::Scene &scene) {
  const auto &b = scene.isolator;
  Joint j{.surface = Surface::interface, .half = b.slider_diameter / 2 - b.top_wall, .wall = b.gap()};
  j.wall_height = b.stop_height, j.name = 'C', j.face = j.half;
  j.friction = {.mu_slow = b.mu_interface, .mu_fast = b.mu_interface, .scale = scene.reduced.measured.scale};
  return j;
}

Parts double_concave_parts(const scene::Scene &scene, bool slow) {
  const auto &b = scene.isolator;
  const double H = b.slider_height(), D = b.slider_diameter;
  Parts parts{.stop_stiffness = scene.reduced.k_i / 2};
  if (scene.impact_resilient()) {
    parts.sliders = {{b.slider_mass * b.bottom_height / H, D, b.bottom_height},
                     {b.slider_mass * b.top_height / H, D, b.top_height}};
    parts.joints = {dish(scene, true, slow), interface(scene), dish(scene, false, slow)};
  } else {
    parts.sliders = {{b.slider_mass, D, H}};
    parts.joints = {dish(scene, true, slow), dish(scene, false, slow)};
  }
  const double rim_mass = mass_before_rim(b, scene.load.mass);
  for (auto &joint : parts.joints) joint.rim_mass = rim_mass;
  return parts;
}

} // namespace

std::vector<Vector2d> point_layout(const scene::Isolator &b, double radius) {
  std::vector<Vector2d> points;
  for (int i = 0; i < b.points; ++i) {
    const double angle = 2 * std::numbers::pi * i / b.points;
    points.push_back(b.space == scene::Space::planar ? Vector2d(radius * (2.0 * i / (b.points - 1) - 1), 0)
                                                     : Vector2d(radius * std::cos(angle), radius * std::sin(angle)));
  }
  return points;
}

Parts parts_of(const scene::Scene &scene, bool slow) {
  Parts parts = scene.triple() ? triple_parts(scene, slow) : double_concave_parts(scene, slow);
  for (auto &joint : parts.joints) joint.friction.area /= scene.isolator.points;
  return parts;
}

} // namespace rimpact::reduced::rigid

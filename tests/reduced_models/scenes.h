/// Scenes the tests of the reduced models start from.
#pragma once
#include "laws/impact/rim_curve.h"
#include "reduced_models/bearings/physical_model.h"
#include <cmath>
#include <numbers>

namespace rimpact::reduced::testing {

using scene::ExcitationKind;

/// The 0.78 g, 1.0 s pulse of the thesis on the default bearing.
inline scene::Scene ricker(double scale = 1.0, double duration = 8.0) {
  scene::Scene s;
  s.excitation.scale = scale;
  s.excitation.duration = duration;
  return s;
}

inline scene::Scene window(double speed = 0.1) {
  scene::Scene s;
  s.excitation.kind = ExcitationKind::window;
  s.excitation.speed = speed;
  s.excitation.duration = 0.2;
  return s;
}

inline scene::Scene free_motion(const Eigen::Vector2d &u, const Eigen::Vector2d &v, double duration = 8.0) {
  scene::Scene s;
  s.excitation.kind = ExcitationKind::free;
  s.excitation.initial_displacement = u;
  s.excitation.initial_velocity = v;
  s.excitation.duration = duration;
  return s;
}

inline void set_friction(scene::Scene &s, double mu) {
  s.reduced.mu_fast = s.reduced.mu_slow = mu;
}

/// A rim that loads with stiffness k and unloads with k_back [N/m], pushed to `range` [m].
inline laws::CurvePath linear_curve(double k, double k_back, double range) {
  laws::CurvePath path{{{0}, {0}}, {}};
  for (int i = 1; i <= 8; ++i)
    path.loading.penetration.push_back(range * i / 8),
        path.loading.force.push_back(k * path.loading.penetration.back());
  for (int i = 1; i <= 4; ++i) {
    const double D = path.loading.penetration[2 * i], top = path.loading.force[2 * i];
    laws::CurveSamples back;
    for (int j = 0; j <= 5; ++j)
      back.penetration.push_back(D - top / k_back * j / 5), back.force.push_back(j == 5 ? 0 : top * (5 - j) / 5);
    path.unloading.push_back(back);
  }
  return path;
}

/// A spherical dish of radius 2.25 m with a rim far away.
inline scene::Scene on_sphere(scene::Scene s) {
  s.bearing.surface = {.kind = scene::SurfaceKind::sphere, .R0 = 2.25, .a = 0.5625, .planar_radius = 1.5};
  return s;
}

/// The ellipse's height, slope and meridional curvature in closed form (2-3).
struct Ellipse {
  double R0 = 2.25, a = 0.5625, b = a * a / R0;
  double height(double r) const { return b - b * std::sqrt(1 - r * r / (a * a)); }
  double slope(double r) const { return b * r / (a * a) / std::sqrt(1 - r * r / (a * a)); }
  double second(double r) const { return b / (a * a) * std::pow(1 - r * r / (a * a), -1.5); }
  double meridional(double r) const { return second(r) / std::pow(1 + slope(r) * slope(r), 1.5); }
  double circumferential(double r) const {
    return r > 0 ? slope(r) / (r * std::sqrt(1 + slope(r) * slope(r))) : 1 / R0;
  }
};

} // namespace rimpact::reduced::testing

/// Slow motion of a triple pendulum in closed form, the independent oracle of the rigid bodies (derived in
/// docs/theory/triple-pendulum.md). Forces over the load; friction as loops give it.
#pragma once
#include "scene/triple_pendulum.h"
#include <algorithm>
#include <array>
#include <cmath>

namespace rimpact::reduced::testing {

/// The backbone of Fenz and Constantinou (2008), Part I: where stages end, and their slopes. Small turns; friction of
/// the inner slider below that of the bottom plate, and that below the top plate's.
struct FenzBackbone {
  std::array<double, 4> R; ///< effective radii, from the ground up
  std::array<double, 4> d; ///< travel of the pivot on each, d_i R_eff,i / R_i
  std::array<double, 4> f; ///< friction

  double slope(int stage) const {
    const double radii[] = {R[1] + R[2], R[0] + R[2], R[0] + R[3], R[1] + R[3], R[1] + R[2]};
    return 1 / radii[stage];
  }
  /// Displacement at which stage I, II, III or IV ends.
  double end(int stage) const {
    const double first = (f[0] - f[1]) * R[1] + (f[0] - f[2]) * R[2], second = first + (f[3] - f[0]) * (R[0] + R[2]),
                 third = second + d[0] * (1 + R[3] / R[0]) - (f[3] - f[0]) * (R[0] + R[3]);
    const double ends[] = {first, second, third, third + (force(3) - force(2)) * (R[1] + R[3])};
    return ends[stage];
  }
  /// Force at that end.
  double force(int stage) const {
    const double forces[] = {f[0], f[3], d[0] / R[0] + f[0], d[3] / R[3] + f[3]};
    return forces[stage];
  }
};

/// A whole loop at finite turns. Each body follows the force within its friction: |gamma - alpha| <= atan f, F = W tan
/// gamma; slide plates stop at the outer rims. u = sum of the distances of the spheres' centres times sin alpha.
struct TripleLoop {
  std::array<double, 3> length, friction, most; ///< lower slide plate, inner slider, upper slide plate
  std::array<double, 3> alpha{};

  TripleLoop(const scene::Isolator &b, std::array<double, 3> f) : friction(f) {
    const auto face = scene::triple_faces(b);
    length = {face[0].effective_radius() - face[1].effective_radius(),
              face[1].effective_radius() + face[2].effective_radius(),
              face[3].effective_radius() - face[2].effective_radius()};
    most = {face[0].tilt(), 1, face[3].tilt()};
  }
  double turned(int i, double gamma) const {
    const double play = std::atan(friction[i]);
    return std::clamp(std::clamp(alpha[i], gamma - play, gamma + play), -most[i], most[i]);
  }
  /// Moves to the displacement u; the force there.
  double move(double u) {
    double low = -1.2, high = 1.2;
    for (int k = 0; k < 60; ++k) {
      const double gamma = (low + high) / 2;
      double reached = 0;
      for (int i = 0; i < 3; ++i) reached += length[i] * std::sin(turned(i, gamma));
      (reached < u ? low : high) = gamma;
    }
    for (int i = 0; i < 3; ++i) alpha[i] = turned(i, low);
    return std::tan(low);
  }
};

} // namespace rimpact::reduced::testing

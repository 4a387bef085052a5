/// The sliding faces of a triple friction pendulum, from the ground up: bottom plate, inner slider below and above, top
/// plate (Fenz and Constantinou 2008; docs/theory/triple-pendulum.md). SI units.
#pragma once
#include "scene/isolator.h"
#include <array>

namespace rimpact::scene {

struct TripleFace {
  double radius;     ///< R_i [m]
  double height;     ///< h_i, from the pivot to the face on the axis [m]
  double half;       ///< half the diameter of the convex face [m]
  double travel;     ///< d_i along the face, from the middle to the rim [m]
  double rim_height; ///< [m]

  double effective_radius() const { return radius - height; }
  double edge_angle() const; ///< phi = asin(half / R) [rad]
  double tilt() const;       ///< asin(d / R): turn of one body on the other at which the rim is touched [rad]
  double rim_radius() const; ///< R sin(tilt + phi) [m]
};

std::array<TripleFace, 4> triple_faces(const Isolator &isolator);

/// Displacement at which the last rim is touched [m]. The inner slider turns by tilt_1 + tilt_2 on one side and by
/// tilt_3 + tilt_4 on the other: the smaller sum is the one it reaches.
double triple_capacity(const Isolator &isolator);
/// Displacement at which the first rim is touched by a start with the sliders in line [m].
double triple_start_capacity(const Isolator &isolator);

/// Throws InputError naming key, value and bound.
void validate_triple(const Isolator &isolator);

} // namespace rimpact::scene

/// What a bearing of rigid bodies is made of, from the ground up: sliders, and joints below each and below the top
/// plate. A new bearing is one more list of them. SI units.
#pragma once
#include "laws/friction/friction_law.h"
#include "reduced_models/rigid_body/contact.h"
#include "scene/scene.h"
#include <vector>

namespace rimpact::reduced::rigid {

/// A solid cylinder with a face below and above.
struct Slider {
  double mass, diameter, height; ///< height on the axis, face to face
};

/// Two faces that slide on each other: a set of contact points on one, a sphere or plane on the other.
struct Joint {
  Surface surface = Surface::dish; ///< dish or interface
  bool points_above = true;        ///< the points are on the body above, and the sphere opens upwards; else below
  double radius = 0;               ///< R of the sphere; 0 for an interface
  double effective_radius = 0;     ///< of a triple pendulum R - h, by which its slip counts in the bearing's travel
  double half = 0;                 ///< of the circle of the points, which is the edge that meets a rim
  double wall = 0;                 ///< radius of the rim about its axis; interface: the gap
  double wall_height = 0;          ///< above the sphere's edge there, or the plane
  double tilt = 0;                 ///< turn of one body on the other at which the rim is touched [rad]
  char name = 'B';                 ///< of its points' signals: B bottom dish, C and D inner faces, A top dish
  double face = 0;                 ///< radius of the sliding face's circle
  bool inner = false;              ///< of a triple pendulum's slide plate and inner slider
  /// m of its rim's dashpot 2 xi sqrt(k m): an impact of the supported mass returns e, if all rims have that one [kg].
  double rim_mass = 0;
  friction::FrictionLaw friction = {}; ///< its area is one point's share
};

struct Parts {
  std::vector<Slider> sliders = {};
  std::vector<Joint> joints = {}; ///< joint j is below slider j, the last below the plate
  double stop_stiffness = 0;      ///< against all rims that have a law, at first touch [N/m]; 0: none has

  /// Height of a body's face on its axis, in its frame: the vertex of the ground and of the plate is their origin [m].
  double face_below(int body) const { return is_slider(body) ? -sliders[body].height / 2 : 0.0; }
  double face_above(int body) const { return is_slider(body) ? sliders[body].height / 2 : 0.0; }

private:
  bool is_slider(int body) const { return body >= 0 && body < static_cast<int>(sliders.size()); }
};
/// Of a joint's rim.
inline const scene::ImpactElement &element_of(const scene::Scene &scene, const Joint &joint) {
  return joint.inner ? scene.inner_element() : scene.reduced;
}
/// `slow`: a quasi-static motion, whose friction is mu_slow.
Parts parts_of(const scene::Scene &scene, bool slow);

/// Where the contact points of a set lie in its plane: on a line (planar) or a circle (spatial).
std::vector<Eigen::Vector2d> point_layout(const scene::Isolator &bearing, double radius);

} // namespace rimpact::reduced::rigid

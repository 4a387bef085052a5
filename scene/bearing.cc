#include "scene/bearing.h"
#include <cmath>
#include <limits>
#include <numbers>

namespace rimpact::scene {

double Bearing::pad_area() const {
  return std::numbers::pi * (pad.outer_radius * pad.outer_radius - pad.inner_radius * pad.inner_radius);
}

double Bearing::recess_radius() const {
  return pad.outer_radius + (pad_is_seated() ? contact.pad_clearance : 0.0);
}

// The cap is centred on the middle of the sliding face, so the slider follows the contact point itself.
double tilt(const Bearing &bearing, double travel) {
  return std::atan(make_surface(bearing.surface)->at(travel, 0).gradient.x());
}

double lift(const Bearing &bearing, double travel) {
  return make_surface(bearing.surface)->at(travel, 0).z;
}

double lift_over_rim(const Bearing &bearing) {
  const auto surface = make_surface(bearing.surface);
  const double top = surface->at(bearing.surface.planar_radius, 0).z + bearing.rim.height - bearing.slider.bottom;
  return top > surface->at(bearing.lateral_capacity(), 0).z ? top : std::numeric_limits<double>::infinity();
}

double slider_mass(const Bearing &bearing) {
  const auto &s = bearing.slider;
  const double radius = s.diameter / 2, height = bearing.foot.cap_radius - s.bottom; // of the socket, a spherical cap
  const double socket = std::numbers::pi * height * height * (bearing.foot.cap_radius - height / 3);
  return bearing.steel.density * (std::numbers::pi * radius * radius * (s.top - s.bottom) - socket);
}

} // namespace rimpact::scene

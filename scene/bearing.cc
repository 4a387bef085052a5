#include "scene/bearing.h"
#include "scene/edge_middle.h"
#include "scene/spherical_cap.h"
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

namespace {

/// R_eff (3-94) [m].
double effective_radius(const Bearing &b) {
  return 2 * b.surface.R0 - b.slider.height;
}

/// At which the rounding is tangent to the wall: out cos(theta) + down sin(theta) + e = wall.
double tilt_at_touch(const Bearing &b) {
  const EdgeMiddle middle(b);
  return std::asin((b.wall_radius() - b.slider.edge_radius) / std::hypot(middle.out, middle.down)) -
         std::atan2(middle.out, middle.down);
}

} // namespace

double Bearing::lateral_capacity() const {
  return double_concave() ? effective_radius(*this) * std::sin(tilt_at_touch(*this))
                          : wall_radius() - slider.diameter / 2;
}

SurfaceSpec Bearing::ridden_surface() const {
  SurfaceSpec ridden = surface;
  if (!double_concave()) return ridden;
  ridden.R0 = ridden.a = effective_radius(*this);
  ridden.planar_radius *= dishes();
  return ridden;
}

// The cap is centred on the middle of the sliding face, so the slider follows the contact point itself.
double tilt(const Bearing &bearing, double travel) {
  return std::atan(make_surface(bearing.ridden_surface())->at(travel, 0).gradient.x());
}

double lift(const Bearing &bearing, double travel) {
  return make_surface(bearing.ridden_surface())->at(travel, 0).z;
}

double rim_top(const Bearing &bearing) {
  return make_surface(bearing.surface)->at(bearing.surface.planar_radius, 0).z + bearing.rim.height;
}

double edge_at_touch(const Bearing &bearing) {
  if (!bearing.double_concave()) return bearing.slider.bottom + lift(bearing, bearing.lateral_capacity());
  const EdgeMiddle middle(bearing);
  const double theta = tilt_at_touch(bearing);
  return bearing.surface.R0 - middle.down * std::cos(theta) + middle.out * std::sin(theta) - bearing.slider.edge_radius;
}

double lift_over_rim(const Bearing &bearing) {
  const double top = rim_top(bearing), edge = edge_at_touch(bearing);
  if (!(top > edge)) return std::numeric_limits<double>::infinity();
  return bearing.double_concave() ? top - edge : top - bearing.slider.bottom;
}

namespace {

template <class Steel, class AnyBearing> std::vector<std::pair<std::string, Steel *>> all_steels(AnyBearing &bearing) {
  std::vector<std::pair<std::string, Steel *>> list{{"steel", &bearing.steel}};
  for (auto &[part, steel] : bearing.part_steels) list.emplace_back(word(part), &steel);
  return list;
}

} // namespace

std::vector<std::pair<std::string, Material *>> steels_of(Bearing &bearing) {
  return all_steels<Material>(bearing);
}

std::vector<std::pair<std::string, const Material *>> steels_of(const Bearing &bearing) {
  return all_steels<const Material>(bearing);
}

std::optional<double> strain_limit(const Bearing &bearing) {
  std::optional<double> least;
  for (const SteelPart part : {SteelPart::rim, SteelPart::dish})
    if (const auto &limit = bearing.steel_of(part).strain_limit; limit && !(least && *least <= *limit)) least = limit;
  return least;
}

double slider_mass(const Bearing &bearing) {
  const auto &s = bearing.slider;
  if (bearing.double_concave()) {
    const double R = bearing.surface.R0, r = s.diameter / 2, face = cap_height(R, r);
    const double beside = std::numbers::pi * (r * r * face - face * face * (R - face / 3)); // a face and its plane
    return bearing.steel_of(SteelPart::slider).density * (std::numbers::pi * r * r * s.height - 2 * beside);
  }
  const double radius = s.diameter / 2, height = bearing.foot.cap_radius - s.bottom; // of the socket, a spherical cap
  const double socket = std::numbers::pi * height * height * (bearing.foot.cap_radius - height / 3);
  return bearing.steel_of(SteelPart::slider).density *
         (std::numbers::pi * radius * radius * (s.top - s.bottom) - socket);
}

} // namespace rimpact::scene

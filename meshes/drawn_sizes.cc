#include "meshes/drawn_sizes.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::meshes {
namespace {

/// Of (x, y, z) from there, for gmsh, in the file's unit.
std::string distance_from(const SizeOn &on, double metres) {
  const auto from = [&](char axis, int i) { return fmt::format("({}-({}))^2", axis, on.centre[i] / metres); };
  const std::string plan = from('x', 0) + "+" + from('y', 1), up = from('z', 2);
  const double radius = on.radius / metres;
  switch (on.shape) {
  case SizeOn::Shape::circle:
    return fmt::format("sqrt((sqrt({})-{})^2+{})", plan, radius, up);
  case SizeOn::Shape::cylinder:
    return fmt::format("abs(sqrt({})-{})", plan, radius);
  case SizeOn::Shape::ball:
    break;
  }
  return fmt::format("abs(sqrt({}+{})-{})", plan, up, radius);
}

} // namespace

std::vector<SizeOn> sizes_of(const scene::OwnMesh &own, const scene::Bearing &bearing, bool with_pad) {
  using enum SizeOn::Shape;
  constexpr double chord = M_PI / 30; // of the radius: tetrahedra have edges of twice the size
  const double wall = bearing.wall_radius(), side = bearing.slider.diameter / 2, bottom = bearing.slider.bottom,
               cap = bearing.foot.cap_radius, pad = bearing.pad.outer_radius, capacity = bearing.lateral_capacity(),
               fine = std::min(own.contact_size, own.size);
  std::vector<SizeOn> sizes{{circle, {wall, 0, scene::edge_at_touch(bearing)}, 0, fine},
                            {circle, {side, 0, bottom}, 0, fine},
                            {cylinder, {0, 0, 0}, wall, chord * wall}};
  for (const double travel : {0.0, capacity}) {
    const double up = scene::lift(bearing, travel);
    sizes.push_back({cylinder, {travel, 0, 0}, side, chord * side});
    if (!bearing.has_pad()) continue;
    sizes.push_back({ball, {travel, 0, up}, cap, chord * cap});
    if (const double rounding = bearing.slider.edge_radius; rounding > 0)
      sizes.push_back({circle, {travel, 0, bottom + up}, side, std::sqrt(side * rounding / 8)});
  }
  if (with_pad) sizes.push_back({cylinder, {0, 0, 0}, pad, chord * pad});
  return sizes;
}

std::string size_expression(const scene::OwnMesh &own, const std::vector<SizeOn> &sizes) {
  const double metres = own.metres();
  std::string size = fmt::format("{}", 2 * own.size / metres);
  for (const SizeOn &on : sizes)
    size = fmt::format("min({},{}+0.33*{})", size, 2 * on.size / metres, distance_from(on, metres));
  return size;
}

} // namespace rimpact::meshes

#include "meshes/plate_section.h"

#include "meshes/units.h"
#include <cmath>

namespace rimpact::meshes {
std::vector<double> plate_layers(const scene::Bearing &bearing, double h) {
  const double base = -bearing.plate.base,
               z0 = scene::make_surface(bearing.surface)->at(bearing.surface.planar_radius, 0).z;
  // Thin below the dish's edge: the rim's foot bends the plate there, which decides the impact force
  // (docs/decisions/0008-mesh-where-the-foot-bends.md).
  std::vector<double> shares = graded_lines({{base, 100 * mm * h}, {z0, 20 * mm * h}});
  for (double &z : shares) z = (z - base) / (z0 - base);
  return shares;
}

namespace {

/// Up the wall: fine where the slider's edge bites. Between two dishes it bites beside the dish, and the tilted slider
/// comes to the wall's top last.
std::vector<Anchor> wall_anchors(const scene::Bearing &bearing, double z0, double h) {
  const double top = scene::rim_top(bearing);
  if (bearing.double_concave()) return {{z0, 2.5 * mm * h}, {top, 8 * mm * h}};
  return {{z0, 9 * mm * h}, {scene::edge_at_touch(bearing), 5 * mm * h}, {top, 40 * mm * h}};
}

} // namespace

/// Sizes [mm] at level 1 are what the refinement study of docs/ settled.
std::vector<Quad9> plate_and_rim(const scene::Bearing &bearing, const PlateSection &plate, double h) {
  const auto surface = scene::make_surface(bearing.surface);
  const auto dish = [&](double r) { return surface->at(r, 0).z; };
  const double edge = bearing.surface.planar_radius, wall = edge + bearing.rim.ledge,
               outer = wall + bearing.rim.thickness;
  const double z0 = dish(edge), base = -bearing.plate.base;

  std::vector<Anchor> radii{{plate.inner_radius, plate.inner_size}, {edge, 40 * mm * h}};
  if (bearing.rim.ledge > 0) radii.push_back({wall, 12 * mm * h});
  radii.back().size = 16 * mm * h;
  radii.push_back({outer, 40 * mm * h});
  const std::vector<double> r = graded_lines(radii);
  std::vector<double> z;
  for (const double share : plate.layers) z.push_back(base + share * (z0 - base));
  z.back() = z0;
  const std::vector<double> above_dish = graded_lines(wall_anchors(bearing, z0, h));
  z.insert(z.end(), above_dish.begin() + 1, above_dish.end());

  // Below the dish the horizontal lines follow its surface.
  const auto point = [&](double radius, double height) -> Point2 {
    if (radius >= edge || height > z0) return {radius, height};
    const double share = (height - base) / (z0 - base);
    return {radius, base + share * (dish(radius) - base)};
  };
  std::vector<Quad9> section;
  for (std::size_t i = 0; i + 1 < r.size(); ++i)
    for (std::size_t j = 0; j + 1 < z.size(); ++j) {
      const bool above = z[j] >= z0 - 1e-12;
      if (above && r[i] < wall - 1e-12) continue;
      Quad9 quad = straight_quad(point(r[i], z[j]), point(r[i + 1], z[j]), point(r[i + 1], z[j + 1]),
                                 point(r[i], z[j + 1]), above ? Volume::rim : Volume::plate);
      const double middle = 0.5 * (r[i] + r[i + 1]);
      quad.nodes[1] = point(middle, z[j]);
      quad.nodes[7] = point(middle, z[j + 1]);
      centre(quad);
      if (j == 0) quad.groups[2] = Surface::fixed;
      if (i == 0) quad.groups[0] = Surface::sector_end;
      if (above && std::abs(r[i] - wall) < 1e-12) quad.groups[0] = Surface::rim_wall;
      if (r[i + 1] <= edge + 1e-12 && std::abs(z[j + 1] - z0) < 1e-12) quad.groups[3] = Surface::dish;
      section.push_back(quad);
    }
  return section;
}

} // namespace rimpact::meshes

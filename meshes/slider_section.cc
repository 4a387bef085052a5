#include "meshes/slider_section.h"

#include "meshes/half_disc.h"
#include "meshes/touched_places.h"
#include "meshes/units.h"
#include <cmath>

namespace rimpact::meshes {
namespace {

/// Heights are measured from the slider's bottom plane; radii from its axis.
struct SliderShape {
  double radius, height, edge;    ///< outer radius, height, rounding
  double cap, cap_depth, opening; ///< socket sphere: radius, centre below the bottom plane, opening radius
  double bottom;                  ///< of the bottom plane, in the plate's frame

  /// Height of the underside: the sphere inside the opening, the bottom plane outside.
  double underside(double r) const { return r >= opening ? 0.0 : std::sqrt(cap * cap - r * r) - cap_depth; }
  /// Layers follow the underside and flatten towards the top.
  Point2 point(double r, double layer) const {
    const double s = underside(r);
    return {r, bottom + s + layer / height * (height - s)};
  }
};

SliderShape shape_of(const scene::Bearing &bearing, double travel) {
  SliderShape s;
  s.radius = bearing.slider.diameter / 2;
  s.height = bearing.slider.top - bearing.slider.bottom;
  s.edge = bearing.slider.edge_radius;
  s.cap = bearing.foot.cap_radius;
  s.cap_depth = bearing.slider.bottom;
  s.opening = s.cap > s.cap_depth ? std::sqrt(s.cap * s.cap - s.cap_depth * s.cap_depth) : 0.0;
  s.bottom = bearing.slider.bottom + scene::lift(bearing, travel);
  return s;
}

/// The grid of the ring between socket and side: columns at `radii`, layers at `inner`, wrapped at the
/// outside by one more column whose wall nodes are `wall`; the last two columns end below at the two halves
/// of the rounded edge.
struct RingGrid {
  std::vector<double> radii, inner, wall;
};

RingGrid ring_grid(const SliderShape &s, double h) {
  const double t = 6 * mm; // depth of the wrapping layer
  RingGrid grid;
  const double step = 3.2 * mm; // the layers' offset from the wall's nodes at the edge
  grid.radii = graded_lines({{s.opening, 45 * mm * h}, {s.radius - t - step, 45 * mm * h}});
  grid.radii.push_back(s.radius - t);
  const std::vector<double> above =
      graded_lines({{s.edge, 5 * mm * h}, {0.5 * s.height, 40 * mm * h}, {s.height, 70 * mm * h}});
  grid.inner = {0.0, t};
  grid.wall = {0.0, s.edge * (1 - std::sqrt(0.5))};
  for (const double height : above) { // offset at the edge, level at the top
    grid.wall.push_back(height);
    grid.inner.push_back(height + (t + step - s.edge) * (s.height - height) / (s.height - s.edge));
  }
  return grid;
}

std::vector<Quad9> ring_section(const SliderShape &s, const RingGrid &grid) {
  const std::size_t columns = grid.radii.size(), layers = grid.inner.size();
  const Point2 centre_of_edge{s.radius - s.edge, s.bottom + s.edge};
  const auto arc = [&](double angle) -> Point2 {
    return {centre_of_edge[0] + s.edge * std::cos(angle), centre_of_edge[1] + s.edge * std::sin(angle)};
  };
  const auto inside = [&](std::size_t i, std::size_t j) -> Point2 {
    if (j > 0 || i + 2 < columns) return s.point(grid.radii[i], grid.inner[j]);
    return arc(i + 1 == columns ? -M_PI / 4 : -M_PI / 2); // below: ends of the rounded edge's lower half
  };
  const auto wall = [&](std::size_t j) -> Point2 {
    return j == 1 ? arc(-M_PI / 4) : Point2{s.radius, s.bottom + grid.wall[j]};
  };
  std::vector<Quad9> section;
  for (std::size_t i = 0; i + 1 < columns; ++i)
    for (std::size_t j = 0; j + 1 < layers; ++j) {
      Quad9 quad =
          straight_quad(inside(i, j), inside(i + 1, j), inside(i + 1, j + 1), inside(i, j + 1), Volume::upper_slider);
      if (j == 0 && i + 2 == columns) {
        quad.nodes[1] = arc(-3 * M_PI / 8);
        quad.groups[2] = Surface::slider_side;
      }
      if (j + 2 == layers) quad.groups[3] = Surface::top;
      centre(quad);
      section.push_back(quad);
    }
  for (std::size_t j = 1; j + 1 < layers; ++j) {
    Quad9 quad =
        straight_quad(inside(columns - 1, j), wall(j), wall(j + 1), inside(columns - 1, j + 1), Volume::upper_slider);
    if (j == 1) quad.nodes[5] = arc(-M_PI / 8);
    quad.groups[1] = Surface::slider_side;
    if (j + 2 == layers) quad.groups[3] = Surface::top;
    centre(quad);
    section.push_back(quad);
  }
  return section;
}

} // namespace

void add_slider(HexMesh &mesh, const scene::Bearing &bearing, double h, double travel,
                const std::vector<double> &places) {
  const SliderShape s = shape_of(bearing, travel);
  const RingGrid grid = ring_grid(s, h);
  // Angles come in equal pairs: gmsh halves every edge of the core's plan.
  const PlaceSizes sizes{2 * 10 * mm * h / s.radius, 20 * mm / s.radius, M_PI / 2, 0.9 * h};
  std::vector<Anchor> anchors = anchors_at(folded(places, sizes.apart()), sizes);
  if (const double left = M_PI - anchors.back().at; left > sizes.past_zone()) {
    anchors.push_back({anchors.back().at + sizes.zone, sizes.fine});
    anchors.push_back({M_PI, std::max(sizes.fine, 2 * 1.5 * h * left / M_PI)});
  } else if (left > 1e-9) {
    anchors.push_back({M_PI, sizes.fine});
  }
  const std::vector<double> angles = halved(graded_lines(anchors));
  Body body(mesh);
  body.revolve(ring_section(s, grid), angles, travel, Surface::symmetry, Surface::symmetry);
  const auto height = [&](double r, double level) {
    return s.point(std::min(r, s.opening), at_level(grid.inner, level))[1];
  };
  body.raise(half_disc(s.opening, angles, 25 * mm * h), grid.inner.size() - 1, travel, height, Volume::upper_slider,
             Surface::socket, Surface::top);
}

} // namespace rimpact::meshes

#include "meshes/slider_section.h"

#include "meshes/half_disc.h"
#include "meshes/slider_angles.h"
#include "meshes/units.h"
#include <cmath>

namespace rimpact::meshes {
namespace {

/// Heights are measured from the slider's bottom, radii from its axis.
struct SliderShape {
  double radius, height, edge; ///< outer radius, height on the axis, rounding
  double sphere, centre;       ///< of the underside: radius; centre above the bottom (< 0: below, a socket)
  double core;                 ///< radius of the middle, meshed as a disc: the socket's opening
  double bottom;               ///< in the plate's frame

  /// Height of the underside: a socket's sphere inside its opening and the bottom plane outside, or a sliding face.
  double underside(double r) const {
    if (centre > 0) return centre - std::sqrt(sphere * sphere - r * r);
    return r >= core ? 0.0 : std::sqrt(sphere * sphere - r * r) + centre;
  }
  double side() const { return height - underside(radius); } ///< height of the side
  /// Of the rounding: height of its middle; where it leaves the underside, from the horizontal (< 0).
  double edge_middle() const {
    return bottom + (centre > 0 ? centre - std::sqrt(std::pow(sphere - edge, 2) - std::pow(radius - edge, 2)) : edge);
  }
  double edge_begins() const { return (centre > 0 ? std::asin((radius - edge) / (sphere - edge)) : 0.0) - M_PI / 2; }
  /// Layers, up to side(), follow the underside and flatten towards the top.
  Point2 point(double r, double layer) const {
    const double s = underside(r);
    return {r, bottom + s + layer / side() * (height - s)};
  }
};

SliderShape shape_of(const scene::Bearing &bearing, double travel) {
  const scene::UpperSlider &slider = bearing.slider;
  const double radius = slider.diameter / 2;
  if (bearing.double_concave()) {
    constexpr double core = 0.5; // of the radius
    const double R = bearing.surface.R0;
    return {radius, slider.height / 2, slider.edge_radius, R, R, core * radius, 0};
  }
  const double cap = bearing.foot.cap_radius, depth = slider.bottom;
  return {radius,
          slider.top - slider.bottom,
          slider.edge_radius,
          cap,
          -depth,
          cap > depth ? std::sqrt(cap * cap - depth * depth) : 0.0,
          slider.bottom + scene::lift(bearing, travel)};
}

/// Turns what was added since node `first` about the centre of the dish, towards +x.
void tilt_about_dish(HexMesh &mesh, std::size_t first, double radius, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (std::size_t i = first; i < mesh.nodes.size(); ++i) {
    auto &[x, y, z] = mesh.nodes[i];
    const double down = radius - z, out = x;
    x = out * c + down * s;
    z = radius - (down * c - out * s);
  }
}

/// The grid of the ring between socket and side: columns at `radii`, layers at `inner`, wrapped at the
/// outside by one more column whose wall nodes are `wall`; the last two columns end below at the two halves
/// of the rounded edge.
struct RingGrid {
  std::vector<double> radii, inner, wall;
};

RingGrid ring_grid(const SliderShape &s, double h) {
  const double t = 6 * mm; // depth of the wrapping layer
  const bool bites = s.centre > 0;
  RingGrid grid;
  const double step = 3.2 * mm; // the layers' offset from the wall's nodes at the edge
  grid.radii = graded_lines({{s.core, 45 * mm * h}, {s.radius - t - step, 45 * mm * h}});
  grid.radii.push_back(s.radius - t);
  const std::vector<double> above =
      graded_lines({{s.edge, (bites ? 2.5 : 5) * mm * h}, {0.5 * s.side(), 40 * mm * h}, {s.side(), 70 * mm * h}});
  grid.inner = {0.0, t};
  grid.wall = {0.0, s.edge * (1 - std::sqrt(0.5))};
  for (const double height : above) { // offset at the edge, level at the top
    grid.wall.push_back(height);
    grid.inner.push_back(height + (t + step - s.edge) * (s.side() - height) / (s.side() - s.edge));
  }
  return grid;
}

/// The middles of a cell's lower and upper line, on their layers.
void follow_underside(Quad9 &quad, const SliderShape &s, double below, double above) {
  quad.nodes[1] = s.point(0.5 * (quad.nodes[0][0] + quad.nodes[2][0]), below);
  quad.nodes[7] = s.point(0.5 * (quad.nodes[6][0] + quad.nodes[8][0]), above);
}

std::vector<Quad9> ring_section(const SliderShape &s, const RingGrid &grid) {
  const std::size_t columns = grid.radii.size(), layers = grid.inner.size();
  const Point2 centre_of_edge{s.radius - s.edge, s.edge_middle()};
  const double begins = s.edge_begins();
  const auto arc = [&](double angle) -> Point2 {
    return {centre_of_edge[0] + s.edge * std::cos(angle), centre_of_edge[1] + s.edge * std::sin(angle)};
  };
  const auto inside = [&](std::size_t i, std::size_t j) -> Point2 {
    if (j > 0 || i + 2 < columns) return s.point(grid.radii[i], grid.inner[j]);
    return arc(i + 1 == columns ? begins / 2 : begins); // below: ends of the rounded edge's lower half
  };
  const auto wall = [&](std::size_t j) -> Point2 {
    if (j == 1) return arc(begins / 2);
    const double from = s.edge_middle(); // above the rounding
    return {s.radius, from + (grid.wall[j] - s.edge) * (s.bottom + s.height - from) / (s.side() - s.edge)};
  };
  std::vector<Quad9> section;
  for (std::size_t i = 0; i + 1 < columns; ++i)
    for (std::size_t j = 0; j + 1 < layers; ++j) {
      Quad9 quad =
          straight_quad(inside(i, j), inside(i + 1, j), inside(i + 1, j + 1), inside(i, j + 1), Volume::upper_slider);
      if (i + 2 < columns) follow_underside(quad, s, grid.inner[j], grid.inner[j + 1]);
      if (j == 0 && i + 2 == columns) {
        quad.nodes[1] = arc(3 * begins / 4);
        quad.groups[2] = Surface::slider_side;
      } else if (j == 0 && s.centre > 0) {
        quad.groups[2] = Surface::pad_face;
      }
      if (j + 2 == layers) quad.groups[3] = Surface::top;
      centre(quad);
      section.push_back(quad);
    }
  for (std::size_t j = 1; j + 1 < layers; ++j) {
    Quad9 quad =
        straight_quad(inside(columns - 1, j), wall(j), wall(j + 1), inside(columns - 1, j + 1), Volume::upper_slider);
    if (j == 1) quad.nodes[5] = arc(begins / 4);
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
  const bool between_dishes = bearing.double_concave(), own_image = between_dishes && travel == 0;
  const std::vector<double> lines = own_image ? quarter_angles(places, s.radius, h) : half_angles(places, s.radius, h);
  Body body(mesh);
  const double axis = between_dishes ? 0.0 : travel;
  const std::size_t first = mesh.nodes.size();
  body.revolve(ring_section(s, grid), own_image ? with_image(lines) : lines, axis, Surface::symmetry,
               Surface::symmetry);
  const auto height = [&](double r, double level) {
    return s.point(std::min(r, s.core), at_level(grid.inner, level))[1];
  };
  body.raise(own_image ? symmetric_half_disc(s.core, lines, 25 * mm * h) : half_disc(s.core, lines, 25 * mm * h),
             grid.inner.size() - 1, axis, height, Volume::upper_slider,
             between_dishes ? Surface::pad_face : Surface::socket, Surface::top);
  if (between_dishes) tilt_about_dish(mesh, first, bearing.surface.R0, scene::tilt(bearing, travel));
}

} // namespace rimpact::meshes

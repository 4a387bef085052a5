#include "calibration/export/section_dxf.h"
#include "io/files/dxf.h"
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace rimpact::calibration {
namespace {

using scene::Bearing;

const double quarter = std::tan(std::numbers::pi / 8); ///< bulge of a quarter turn

/// The sliding surface from one edge of the dish to the other, x falling [mm].
DxfOutline dish_line(const Bearing &bearing) {
  constexpr double most_off = 1e-6; // [m] of a chord from its arc
  const auto surface = make_surface(bearing.surface);
  const double edge = bearing.surface.planar_radius;
  const auto at = [&](double r, double bulge) {
    return DxfVertex{1e3 * r, 1e3 * surface->at(std::abs(r), 0).z, bulge};
  };
  if (bearing.surface.kind == scene::SurfaceKind::sphere) // clockwise from right to left over the vertex below
    return {at(edge, -std::tan(std::asin(edge / bearing.surface.R0) / 2)), at(-edge, 0)};
  double sharpest = 0;
  constexpr int n_looked = 200;
  for (int i = 0; i < n_looked; ++i) sharpest = std::max(sharpest, surface->curvatures(edge * i / n_looked).meridional);
  const double chord = sharpest > 0 ? std::sqrt(8 * most_off / sharpest) : edge;
  const int half = static_cast<int>(std::ceil(edge / chord));
  DxfOutline line;
  for (int i = half; i >= -half; --i) line.push_back(at(edge * i / half, 0));
  return line;
}

DxfOutline rectangle(double left, double right, double low, double high) {
  return {{1e3 * left, 1e3 * low}, {1e3 * right, 1e3 * low}, {1e3 * right, 1e3 * high}, {1e3 * left, 1e3 * high}};
}

/// Edge of the dish, above the vertex [m].
double edge_height(const Bearing &bearing) {
  return make_surface(bearing.surface)->at(bearing.surface.planar_radius, 0).z;
}

DxfOutline plate(const Bearing &bearing) {
  const double outer = bearing.wall_radius() + bearing.rim.thickness, edge = edge_height(bearing);
  DxfOutline outline{
      {-1e3 * outer, -1e3 * bearing.plate.base}, {1e3 * outer, -1e3 * bearing.plate.base}, {1e3 * outer, 1e3 * edge}};
  for (const auto &vertex : dish_line(bearing)) outline.push_back(vertex);
  outline.push_back({-1e3 * outer, 1e3 * edge});
  return outline;
}

DxfOutline rim(const Bearing &bearing) {
  const double wall = bearing.wall_radius();
  return rectangle(wall, wall + bearing.rim.thickness, edge_height(bearing), rim_top(bearing));
}

/// Upright on its pad, with its socket, its middle at x = 0.
DxfOutline slider(const Bearing &bearing) {
  const auto &s = bearing.slider;
  const double r = 1e3 * s.diameter / 2, low = 1e3 * s.bottom, high = 1e3 * s.top, e = 1e3 * s.edge_radius,
               cap = 1e3 * bearing.foot.cap_radius;
  DxfOutline outline;
  if (cap > low) { // clockwise over the socket's top
    const double opening = std::sqrt(cap * cap - low * low);
    outline = {{-opening, low, -std::tan(std::atan2(opening, low) / 2)}, {opening, low}};
  }
  outline.insert(outline.end(),
                 {{r - e, low, quarter}, {r, low + e}, {r, high}, {-r, high}, {-r, low + e, quarter}, {-r + e, low}});
  return outline;
}

DxfOutline foot(const Bearing &bearing) {
  const auto &f = bearing.foot;
  const double r = 1e3 * f.radius, low = 1e3 * f.bottom, shoulder = 1e3 * f.shoulder, cap = 1e3 * f.cap_radius,
               seat = 1e3 * bearing.pad.thickness, recess = 1e3 * bearing.recess_radius(),
               edge = std::sqrt(cap * cap - shoulder * shoulder);
  return {{recess, low},     {r, low},       {r, shoulder}, {edge, shoulder, std::tan(std::atan2(edge, shoulder) / 2)},
          {-edge, shoulder}, {-r, shoulder}, {-r, low},     {-recess, low},
          {-recess, seat},   {recess, seat}};
}

/// What stands right of the axis.
DxfOutline pad(const Bearing &bearing) {
  const auto &p = bearing.pad;
  const double inner = 1e3 * p.inner_radius, outer = 1e3 * p.outer_radius, face = 1e3 * p.shape_radius,
               from = std::asin(inner / face), to = std::asin(outer / face);
  return {{inner, face * (1 - std::cos(from)), std::tan((to - from) / 4)},
          {outer, face * (1 - std::cos(to))},
          {outer, 1e3 * p.thickness},
          {inner, 1e3 * p.thickness}};
}

/// Between two dishes: both faces are spheres of their radius, both edges rounded.
DxfOutline biconvex(const Bearing &bearing) {
  const double R = 1e3 * bearing.surface.R0, r = 1e3 * bearing.slider.diameter / 2,
               e = 1e3 * bearing.slider.edge_radius, height = 1e3 * bearing.slider.height;
  const double lean = std::asin((r - e) / (R - e)), middle = R - (R - e) * std::cos(lean);
  const double face = std::tan(lean / 2), edge = std::tan((std::numbers::pi / 2 - lean) / 4);
  const double x = R * std::sin(lean), z = R - R * std::cos(lean);
  return {{-x, z, face},         {x, z, edge},           {r, middle},           {r, height - middle, edge},
          {x, height - z, face}, {-x, height - z, edge}, {-r, height - middle}, {-r, middle, edge}};
}

void draw_plates(DxfDrawing &drawing, const Bearing &bearing) {
  drawing.outline("PLATE", plate(bearing));
  for (const auto &side : {rim(bearing), mirrored_in_x(rim(bearing))}) drawing.outline("RIM", side);
  if (!bearing.double_concave()) return;
  const double middle = 1e3 * bearing.slider.height / 2;
  drawing.layer("UPPER_PLATE", 8), drawing.layer("UPPER_RIM", 1);
  drawing.outline("UPPER_PLATE", mirrored_in_y(plate(bearing), middle));
  for (const auto &side : {rim(bearing), mirrored_in_x(rim(bearing))})
    drawing.outline("UPPER_RIM", mirrored_in_y(side, middle));
}

void draw_slider(DxfDrawing &drawing, const Bearing &bearing) {
  if (bearing.double_concave()) return drawing.outline("SLIDER", biconvex(bearing));
  drawing.layer("FOOT", 3), drawing.layer("PAD", 4);
  drawing.layer("SLIDER_AT_TOUCH", 9, DxfDrawing::Line::dashed);
  drawing.outline("SLIDER", slider(bearing));
  drawing.outline("FOOT", foot(bearing));
  for (const auto &side : {pad(bearing), mirrored_in_x(pad(bearing))}) drawing.outline("PAD", side);
  const double travel = bearing.lateral_capacity();
  drawing.outline("SLIDER_AT_TOUCH", moved(slider(bearing), 1e3 * travel, 1e3 * lift(bearing, travel)));
}

} // namespace

std::string section_dxf(const Bearing &bearing, const std::vector<std::string> &head) {
  DxfDrawing drawing;
  drawing.layer("PLATE", 8), drawing.layer("RIM", 1), drawing.layer("SLIDER", 5);
  drawing.layer("AXIS", 2, DxfDrawing::Line::centre), drawing.layer("TEXT", 7);
  draw_plates(drawing, bearing);
  draw_slider(drawing, bearing);
  const double base = 1e3 * bearing.plate.base, left = -1e3 * (bearing.wall_radius() + bearing.rim.thickness),
               top = 1e3 * (bearing.double_concave() ? bearing.slider.height + bearing.plate.base : bearing.slider.top);
  drawing.outline("AXIS", {{0, -base - 20}, {0, top + 20}}, false);
  constexpr double letters = 12; // mm
  drawing.text("TEXT", left, -base - 2 * letters, letters,
               fmt::format("{}: section at rest, mm; L_c = {:.4g} mm; rim {:g} x {:g} mm", bearing.name,
                           1e3 * bearing.lateral_capacity(), 1e3 * bearing.rim.thickness, 1e3 * bearing.rim.height));
  std::string assumed;
  for (const auto &[key, value] : assumptions(bearing))
    assumed += fmt::format("{}{}", assumed.empty() ? "" : ", ", key);
  if (!assumed.empty())
    drawing.text("TEXT", left, -base - 4 * letters, letters / 2, "assumed, not the maker's: " + assumed);
  return drawing.file(head);
}

} // namespace rimpact::calibration

#include "meshes/pad_and_foot.h"

#include "meshes/half_disc.h"
#include "meshes/units.h"
#include <cmath>

namespace rimpact::meshes {
namespace {

struct Shape {
  double inner, outer, seat, face;      ///< pad: radii, height of its seat, radius of its face
  double recess;                        ///< radius of the wall around the pad
  double radius, bottom, shoulder, cap; ///< foot
  explicit Shape(const scene::Bearing &b)
      : inner(b.pad.inner_radius), outer(b.pad.outer_radius), seat(b.pad.thickness), face(b.pad.shape_radius),
        recess(b.recess_radius()), radius(b.foot.radius), bottom(b.foot.bottom), shoulder(b.foot.shoulder),
        cap(b.foot.cap_radius) {}
  double cap_at(double r) const { return std::sqrt(cap * cap - r * r); }
  double face_at(double r) const { return face - std::sqrt(face * face - r * r); }
  double cap_radius_at_shoulder() const { return std::sqrt(cap * cap - shoulder * shoulder); }
};

/// Cells between two height functions of r, `layers` of them; groups on the lowest and highest edges.
std::vector<Quad9> band(const std::vector<double> &radii, int layers, const std::function<double(double)> &low,
                        const std::function<double(double)> &high, Volume volume, std::optional<Surface> below,
                        std::optional<Surface> above) {
  const auto point = [&](double r, int layer) -> Point2 { return {r, low(r) + (high(r) - low(r)) * layer / layers}; };
  std::vector<Quad9> section;
  for (std::size_t i = 0; i + 1 < radii.size(); ++i)
    for (int j = 0; j < layers; ++j) {
      Quad9 quad = straight_quad(point(radii[i], j), point(radii[i + 1], j), point(radii[i + 1], j + 1),
                                 point(radii[i], j + 1), volume);
      const double middle = 0.5 * (radii[i] + radii[i + 1]);
      quad.nodes[1] = point(middle, j);
      quad.nodes[7] = point(middle, j + 1);
      centre(quad);
      if (j == 0 && below) quad.groups[2] = *below;
      if (j + 1 == layers && above) quad.groups[3] = *above;
      section.push_back(quad);
    }
  return section;
}

/// Puts a group on the section's edges that stand at a radius, `outward` of the cells' or their inner ones.
void mark(std::vector<Quad9> &section, double radius, bool outward, Surface group) {
  for (Quad9 &quad : section)
    if (quad.nodes[outward ? 2 : 0][0] == radius) quad.groups[outward ? 1 : 0] = group;
}

} // namespace

void add_pad_and_foot(HexMesh &mesh, const scene::Bearing &bearing, double h) {
  const Shape s(bearing);
  const int layers = std::max(2, static_cast<int>(std::lround(2 / h))), pad_layers = layers + 1;
  const std::vector<double> annulus = graded_lines({{s.inner, 14 * mm * h}, {s.outer, 11 * mm * h}});
  std::vector<double> angles; // an even number of equal intervals, as half_disc asks
  for (int k = 0, n = 2 * static_cast<int>(std::lround(6 / h)); k <= n; ++k) angles.push_back(M_PI * k / n);
  const auto seat = [&](double) { return s.seat; };
  const auto cap = [&](double r) { return s.cap_at(r); };

  const bool apart = bearing.pad_is_seated();
  const auto seated = [&](Surface group) { return apart ? std::optional(group) : std::nullopt; };

  Body pad(mesh);
  std::vector<Quad9> pad_section = band(
      annulus, pad_layers, [&](double r) { return s.face_at(r); }, seat, Volume::pad, Surface::pad_face,
      seated(Surface::pad_top));
  if (apart) mark(pad_section, s.outer, true, Surface::pad_side);
  pad.revolve(pad_section, angles, 0.0, Surface::symmetry, Surface::symmetry);

  Body lens(pad, [&](const std::array<double, 3> &) { return !apart; });
  std::vector<double> covered = annulus; // the foot's radii above the seat
  covered.back() = s.recess;
  lens.revolve(band(covered, layers, seat, cap, Volume::foot, seated(Surface::foot_seat), Surface::foot_cap), angles,
               0.0, Surface::symmetry, Surface::symmetry);
  const auto middle = [&](double r, double level) { // the foot's, inside the pad's hole
    return s.seat + (s.cap_at(std::min(r, s.inner)) - s.seat) * level / layers;
  };
  lens.raise(half_disc(s.inner, angles, 12 * mm * h), layers, 0.0, middle, Volume::foot, seated(Surface::foot_seat),
             Surface::foot_cap);

  // The ring around the pad is joined to the foot above the seat alone: below it, its wall only faces the pad.
  Body ring(lens, [&](const std::array<double, 3> &x) { return x[2] > s.seat - 1e-9; });
  const double edge = s.cap_radius_at_shoulder();
  std::vector<double> radii = graded_lines({{s.recess, 10 * mm * h}, {edge, 10 * mm * h}});
  const auto waist = [&](double r) { // from the seat to the middle of the foot's outer wall
    return s.seat + (r - s.recess) / (s.radius - s.recess) * (0.5 * (s.bottom + s.shoulder) - s.seat);
  };
  const auto floor = [&](double) { return s.bottom; };
  const auto add = [&](const std::vector<Quad9> &section) {
    ring.revolve(section, angles, 0.0, Surface::symmetry, Surface::symmetry);
  };
  std::vector<Quad9> below_seat = band(radii, layers - 1, floor, waist, Volume::foot, {}, {});
  if (apart) mark(below_seat, s.recess, false, Surface::foot_recess);
  add(below_seat);
  add(band(radii, layers, waist, cap, Volume::foot, {}, Surface::foot_cap));
  if (s.radius - edge < 1e-6) return;
  radii = {edge, s.radius};
  add(band(radii, layers - 1, floor, waist, Volume::foot, {}, {}));
  add(band(radii, layers, waist, [&](double) { return s.shoulder; }, Volume::foot, {}, {}));
}

} // namespace rimpact::meshes

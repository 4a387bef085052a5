/// Bearing::validate(), validate_rim() and check_bearing(): what cannot be built or collides over 0..L_c is refused
/// with both numbers.
#include "io/files/require.h"
#include "scene/flow_curve.h"
#include "scene/keys.h"
#include "scene/range_check.h"
#include "scene/spherical_cap.h"
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace rimpact::scene {
namespace {

double mm(double metres) {
  return std::round(metres * 1e6) / 1e3;
} // shown to a micrometre

void check_materials(const Bearing &b) {
  const auto check = [](const std::string &name, const Material &m) {
    if (!m.tangent_modulus) return;
    require(m.yield.has_value(), "material.{}.tangent_modulus_MPa {} needs a finite yield_MPa", name,
            *m.tangent_modulus / 1e6);
    require(*m.tangent_modulus < m.E, "material.{}.tangent_modulus_MPa {} must be below E_MPa {}", name,
            *m.tangent_modulus / 1e6, m.E / 1e6);
  };
  for (const auto &[name, steel] : steels_of(b)) {
    check(name, *steel);
    if (steel->yield) check_hardening(name, *steel);
  }
  check("ertalyte", b.ertalyte);
}

/// Between two dishes: a face is shaped to its dish, and the slider's edge comes to the wall before the dishes end.
void check_two_dishes(const Bearing &b) {
  constexpr double drawn = 1e-3; // what rounded figures may leave [m]
  const auto &s = b.slider;
  const double R = b.surface.R0, radius = s.diameter / 2, wall = b.wall_radius();
  require(b.surface.kind == SurfaceKind::sphere, "surface.concave \"{}\" needs surface.kind \"{}\", not \"{}\"",
          word(b.surface.concave), word(SurfaceKind::sphere), word(b.surface.kind));
  require(radius < wall, "slider.diameter_mm {} mm leaves no travel in a rim of radius {} mm", mm(s.diameter),
          mm(wall));
  require(wall - s.edge_radius < R - s.edge_radius,
          "surface.planar_radius_mm {} mm reaches beyond the sphere, which ends at {} mm (R0_m)", mm(wall), mm(R));
  require(s.edge_radius < radius, "slider.edge_radius_mm {} mm must be below the slider's radius {} mm",
          mm(s.edge_radius), mm(radius));
  const double face = cap_height(R, radius);
  require(
      s.height > 2 * (face + s.edge_radius),
      "slider.height_mm {} mm must exceed {:.5g} mm: its two faces rise by {:.4g} mm each, and its edges are rounded "
      "by {} mm",
      mm(s.height), 2e3 * (face + s.edge_radius), 1e3 * face, mm(s.edge_radius));
  const double lower = b.rim.height - (rim_top(b) - s.height / 2);
  const bool still_a_rim = lower > 0 && s.height / 2 > edge_at_touch(b) + s.edge_radius;
  require(2 * rim_top(b) <= s.height + drawn,
          "rim.height_mm {} mm: at rest the rims of the two plates would lie in one another by {:.3g} mm; "
          "slider.height_mm must be {:.5g} mm or more{}",
          mm(b.rim.height), 1e3 * (2 * rim_top(b) - s.height), 2e3 * rim_top(b),
          still_a_rim ? fmt::format(", or rim.height_mm {:.5g} mm or less", 1e3 * lower) : "");
  require(s.interface_gap < radius || !s.mu_interface,
          "slider.interface_gap_mm {} mm must be below the slider's radius {} mm: its halves would leave one another",
          mm(s.interface_gap), mm(radius));
  require(s.height < 2 * R, "slider.height_mm {} mm must be below 2 R = {} mm: R_eff = 2 R - H_s", mm(s.height),
          mm(2 * R));
}

void check_dish(const Bearing &b) {
  const auto &s = b.surface;
  const auto surface = make_surface(s);
  const double limit = surface->limit_radius();
  require(s.planar_radius < limit, "surface.planar_radius_mm {} mm reaches beyond the {}, which ends at {} mm ({})",
          mm(s.planar_radius), word(s.kind), mm(limit),
          s.kind == SurfaceKind::ellipse ? "a_m"
          : s.kind == SurfaceKind::table ? "the last radius_mm"
                                         : "R0_m");
  constexpr int n_radii = 400;
  for (int i = 1; i <= n_radii; ++i) {
    const double r = s.planar_radius * i / n_radii, slope = surface->at(r, 0).gradient.x();
    require(slope >= 0 && slope < 10,
            "surface.planar_radius_mm {} mm: at a radius of {} mm the {} has a slope of {:.4g}, outside 0 to "
            "10; a dish rises outwards",
            mm(s.planar_radius), mm(r), word(s.kind), slope);
  }
  if (b.double_concave()) return check_two_dishes(b);
  require(b.lateral_capacity() > 0,
          "slider.diameter_mm {} mm leaves no travel in a rim of radius {} mm: L_c = {} mm must be > 0",
          mm(b.slider.diameter), mm(s.planar_radius + b.rim.ledge), mm(b.lateral_capacity()));
}

/// Bolts stand in the wall's thickness and do not overlap.
void check_connection(const Bearing &b) {
  const RimConnection &c = b.rim.connection;
  if (c.kind != ConnectionKind::bolts) return;
  const double wall = b.wall_radius(), outer = wall + b.rim.thickness, bolt = diameter(c.size);
  require(c.circle - bolt >= 2 * wall && c.circle + bolt <= 2 * outer,
          "rim.connection.circle_mm {} mm with bolts {} leaves the wall, which stands between {} and {} mm",
          mm(c.circle), word(c.size), mm(2 * wall), mm(2 * outer));
  require(c.number >= 3, "rim.connection.number {} must be 3 or more", c.number);
  const double pitch = std::numbers::pi * c.circle / c.number;
  require(pitch > 2 * bolt, "rim.connection.number {} of bolts {} stand {} mm apart, less than twice their diameter",
          c.number, word(c.size), mm(pitch));
}

void check_slider(const Bearing &b) {
  const auto &s = b.slider;
  const double cap = b.foot.cap_radius, radius = s.diameter / 2;
  require(s.bottom < s.top, "slider.top_mm {} mm must lie above slider.bottom_mm {} mm", mm(s.top), mm(s.bottom));
  require(cap > s.bottom, "foot.cap_radius_mm {} mm does not reach slider.bottom_mm {} mm: there is no socket", mm(cap),
          mm(s.bottom));
  require(cap < s.top, "slider.top_mm {} mm must lie above the socket's apex at foot.cap_radius_mm {} mm", mm(s.top),
          mm(cap));
  const double opening = std::sqrt(cap * cap - s.bottom * s.bottom);
  require(opening < radius, "slider.diameter_mm {} mm is too small for its socket, {} mm wide at the bottom plane",
          mm(s.diameter), mm(2 * opening));
  require(s.edge_radius < radius - opening,
          "slider.edge_radius_mm {} mm must be below the {} mm left between the socket and the slider's wall",
          mm(s.edge_radius), mm(radius - opening));
  require(s.edge_radius < s.top - s.bottom, "slider.edge_radius_mm {} mm must be below the slider's height {} mm",
          mm(s.edge_radius), mm(s.top - s.bottom));
}

void check_foot_and_pad(const Bearing &b) {
  const auto &f = b.foot;
  const auto &p = b.pad;
  require(f.radius < f.cap_radius,
          "foot.radius_mm {} mm must be below foot.cap_radius_mm {} mm: the foot is wider than "
          "its cap",
          mm(f.radius), mm(f.cap_radius));
  require(f.bottom < f.shoulder, "foot.shoulder_mm {} mm must lie above foot.bottom_mm {} mm", mm(f.shoulder),
          mm(f.bottom));
  require(f.shoulder < f.cap_radius, "foot.shoulder_mm {} mm must lie below the cap's apex at {} mm", mm(f.shoulder),
          mm(f.cap_radius));
  const double cap_at_shoulder = std::sqrt(f.cap_radius * f.cap_radius - f.shoulder * f.shoulder);
  constexpr double as_narrow = 1e-7; // [m]: rounding of a drawing's numbers
  require(cap_at_shoulder <= f.radius + as_narrow,
          "foot.radius_mm {:.8g} mm is narrower than its cap, {:.8g} mm at foot.shoulder_mm {} mm", 1e3 * f.radius,
          1e3 * cap_at_shoulder, mm(f.shoulder));
  require(p.inner_radius < p.outer_radius, "pad.inner_radius_mm {} mm must be below pad.outer_radius_mm {} mm",
          mm(p.inner_radius), mm(p.outer_radius));
  require(p.outer_radius < f.radius,
          "pad.outer_radius_mm {} mm must be below foot.radius_mm {} mm: the pad is wider "
          "than the foot",
          mm(p.outer_radius), mm(f.radius));
  require(b.recess_radius() < cap_at_shoulder,
          "contact.pad_clearance_mm {:g} mm makes the recess {:g} mm in radius, wider than the cap's {:g} mm at "
          "foot.shoulder_mm",
          1e3 * b.contact.pad_clearance, 1e3 * b.recess_radius(), 1e3 * cap_at_shoulder);
  require(p.recess < p.thickness, "pad.recess_mm {} mm must be below pad.thickness_mm {} mm", mm(p.recess),
          mm(p.thickness));
  require(std::abs(p.thickness - p.recess - f.bottom) < 1e-6,
          "foot.bottom_mm {} mm must equal pad.thickness_mm - pad.recess_mm = {} mm: the pad's face passes "
          "through the "
          "vertex",
          mm(f.bottom), mm(p.thickness - p.recess));
  require(p.outer_radius < p.shape_radius, "pad.shape_radius_mm {} mm must exceed pad.outer_radius_mm {} mm",
          mm(p.shape_radius), mm(p.outer_radius));
  const double rise = p.shape_radius - std::sqrt(p.shape_radius * p.shape_radius - p.outer_radius * p.outer_radius);
  require(rise < f.bottom,
          "pad.shape_radius_mm {} mm raises the pad's face by {} mm at its edge, above foot.bottom_mm "
          "{} mm",
          mm(p.shape_radius), mm(rise), mm(f.bottom));
  const double seat_corner = std::hypot(b.recess_radius(), p.thickness);
  require(seat_corner < f.cap_radius,
          "pad.recess_mm {} mm cuts through the cap: the seat's corner is {} mm from the "
          "cap's centre, foot.cap_radius_mm is {} mm",
          mm(p.recess), mm(seat_corner), mm(f.cap_radius));
}

/// Clearances at one travel; the foot tilts with the surface, the upper slider does not.
class Clearance {
public:
  Clearance(const Bearing &b) : b_(b), surface_(make_surface(b.surface)) {}

  void check_slider(double travel) const {
    const auto here = surface_->at(travel, 0);
    const double bottom = b_.slider.bottom + here.z, reach = travel + b_.slider.diameter / 2;
    require(bottom > height(reach),
            "slider.bottom_mm {} mm: at a travel of {} mm the slider's bottom, at z = {} mm, meets the dish "
            "at z = {} mm",
            mm(b_.slider.bottom), mm(travel), mm(bottom), mm(height(reach)));
  }
  void check_stack(double travel) const {
    const auto here = surface_->at(travel, 0);
    const double slope = std::atan(here.gradient.x()), c = std::cos(slope), s = std::sin(slope);
    const double pad_edge = travel + b_.pad.outer_radius * c;
    require(pad_edge < b_.surface.planar_radius,
            "pad.outer_radius_mm {} mm: at a travel of {} mm the pad reaches {} mm, past the dish's edge at "
            "{} mm",
            mm(b_.pad.outer_radius), mm(travel), mm(pad_edge), mm(b_.surface.planar_radius));
    const double shoulder = b_.foot.radius * s + b_.foot.shoulder * c;
    require(shoulder < b_.slider.bottom,
            "foot.shoulder_mm {} mm: tilted by {:.1f} deg at a travel of {} mm the shoulder rises to {} mm "
            "and meets the "
            "slider's bottom plane at {} mm",
            mm(b_.foot.shoulder), slope * 180 / std::numbers::pi, mm(travel), mm(shoulder), mm(b_.slider.bottom));
    for (int i = 0; i <= 12; ++i) check_foot(travel, here.z, c, s, std::numbers::pi * i / 12);
  }
  double height(double radius) const { return surface_->at(std::min(radius, b_.surface.planar_radius), 0).z; }

private:
  /// The lower edge of the foot at an azimuth must clear the dish.
  void check_foot(double travel, double lifted, double c, double s, double azimuth) const {
    const double along = b_.foot.radius * std::cos(azimuth), across = b_.foot.radius * std::sin(azimuth);
    const double x = travel + along * c - b_.foot.bottom * s, z = lifted + along * s + b_.foot.bottom * c;
    const double radius = std::hypot(x, across);
    require(radius < b_.wall_radius(),
            "foot.radius_mm {} mm: at a travel of {} mm the foot reaches {} mm and meets the rim's wall at {} mm",
            mm(b_.foot.radius), mm(travel), mm(radius), mm(b_.wall_radius()));
    require(z > height(radius),
            "foot.bottom_mm {} mm: at a travel of {} mm the foot's lower edge, at z = {} mm, meets the dish "
            "at z = {} mm",
            mm(b_.foot.bottom), mm(travel), mm(z), mm(height(radius)));
  }
  const Bearing &b_;
  std::unique_ptr<SlidingSurface> surface_;
};

void check_rim(const Bearing &b) {
  const double top = rim_top(b), bottom = edge_at_touch(b);
  require(top > bottom,
          "rim.height_mm {} mm leaves the rim's top at z = {} mm, below the slider's bottom at {} mm when "
          "it touches",
          mm(b.rim.height), mm(top), mm(bottom));
  require(top > bottom + b.slider.edge_radius,
          "rim.height_mm {} mm leaves the rim's top at z = {} mm: it meets only the "
          "rounded edge of the slider, which ends at {} mm when it touches",
          mm(b.rim.height), mm(top), mm(bottom + b.slider.edge_radius));
}

void check_friction(const ContactFriction &c) {
  const auto check = [&](const char *name, double fast, const std::optional<double> &slow) {
    if (!slow) return;
    require(*slow <= fast, "contact.{0}_slow {1} exceeds contact.{0} {2}", name, *slow, fast);
    require(*slow == fast || c.rate > 0, "contact.rate_s_per_m {} must be > 0 where contact.{}_slow {} differs from {}",
            c.rate, name, *slow, fast);
  };
  check("steel_steel", c.steel_steel, c.steel_steel_slow);
  check("steel_ertalyte", c.steel_ertalyte, c.steel_ertalyte_slow);
  check("rim", c.rim, c.rim_slow);
}

constexpr int n_positions = 64; // of the travel at which clearances are checked

/// Dish, slider and rim, with the pad and foot between them or without.
void check(const Bearing &b, bool with_stack) {
  check_ranges(b);
  check_materials(b);
  check_friction(b.contact);
  check_dish(b);
  check_connection(b);
  if (b.double_concave()) return check_rim(b);
  check_slider(b);
  require(!(b.pad.loss_factor > 0 && b.ertalyte.yield),
          "pad.loss_factor {:g} beside a material.ertalyte.yield_MPa: a pad that loses energy as it strains is elastic",
          b.pad.loss_factor);
  if (with_stack) check_foot_and_pad(b);
  const Clearance clearance(b);
  for (int i = 0; i <= n_positions; ++i) {
    const double travel = b.lateral_capacity() * i / n_positions;
    clearance.check_slider(travel);
    if (with_stack) clearance.check_stack(travel);
  }
  check_rim(b);
}

bool needs_only_the_dish(const Scene &s) {
  if (s.reduced.finite_pad || s.reduced.socket_friction) return false;
  return s.superstructure.any() || (s.excitation.stays_on_dish() && !has_dish(s.model.rung));
}

} // namespace

void check_bearing(const Scene &scene) {
  if (scene.rigid_bodies()) return;
  if (needs_only_the_dish(scene)) {
    check_ranges(scene.bearing);
    return check_dish(scene.bearing);
  }
  require(scene.bearing.has_pad() || !(scene.reduced.finite_pad || scene.reduced.socket_friction),
          "reduced.{} is not for surface.concave \"{}\": a slider between two dishes has neither pad nor socket",
          scene.reduced.finite_pad ? "finite_pad" : "socket_friction", word(scene.bearing.surface.concave));
  scene.needs_stack() ? scene.bearing.validate() : scene.bearing.validate_rim();
}

void Bearing::validate() const {
  check(*this, true);
}

void Bearing::validate_rim() const {
  check(*this, false);
}

} // namespace rimpact::scene

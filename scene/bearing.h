/// A friction-pendulum bearing with a restraining rim: every dimension, in SI.
/// Frame: origin at the dish's vertex, z up; the plate is fixed, the upper slider moves.
///
/// With `surface.concave` "double" two like dishes face each other and one slider, whose faces are shaped to them, lies
/// between. Dish, rim and plate are those of one of them; pad, foot and Ertalyte are not read. A half turn about the
/// slider's middle maps one half on the other, so the slider's middle moves half as far as what the bearing carries.
/// Values marked *assumption* are the built-in bearings' (the thesis's drawing is not available). In a bearing of
/// someone's own a number that its file leaves to its default, or marks, is one: `Bearing::assumed`, listed by
/// `assumptions()`.
#pragma once
#include "scene/material.h"
#include "scene/rim_connection.h"
#include "scene/surface.h"
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace rimpact::scene {

struct UpperSlider {
  double diameter = 0.240; ///< b_s [m]
  double bottom = 0.05825; ///< bottom plane above the vertex at rest [m], assumption
  double top = 0.15825;    ///< top plane above the vertex at rest [m], assumption
  double height = 0.100;   ///< between two dishes: H_s on its axis, from face to face [m]; bottom and top are not read
  double edge_radius = 0.002; ///< rounding of the lower edge, between two dishes of both [m], >= 0, assumption
  /// mu_s of the plane across the middle of a slider between two dishes, on which its halves slide (LIR-DCFP; thesis
  /// section 3.2), constant in speed [-]; empty: it is one piece.
  std::optional<double> mu_interface;
  double interface_gap = 0.030; ///< slip of the halves at which they meet their stop [m], > 0, assumption
  bool operator==(const UpperSlider &) const = default;
};
struct Rim {
  double height = 0.060;    ///< above the dish's edge [m], assumption
  double thickness = 0.040; ///< radial [m], assumption
  double ledge = 0.0;       ///< flat step between dish edge and wall [m], assumption
  RimConnection connection = {};
  bool operator==(const Rim &) const = default;
};
struct Plate {
  double base = 0.050; ///< bottom plane below the vertex [m], assumption
  bool operator==(const Plate &) const = default;
};
struct Pad {                                           // assumption, but for its area (853 kN at 60 MPa)
  double inner_radius = 0.020, outer_radius = 0.07019; ///< [m]
  double thickness = 0.040, recess = 0.020;            ///< [m]
  double shape_radius = 1.400;                         ///< of its face [m]
  double loss_factor = 0; ///< of its material, at the frequency at which the load swings on it [-], 0 <= eta <= 0.5
  bool operator==(const Pad &) const = default;
};
struct Foot {                                              // assumption
  double radius = 0.086, bottom = 0.020, shoulder = 0.033; ///< [m]
  double cap_radius = 0.090; ///< of the spherical cap, centred on the middle of the sliding face [m]
  bool operator==(const Foot &) const = default;
};
/// How the pad sits in the foot.
enum class PadFoot {
  tied,      ///< one piece with it on the seat; the recess's wall does not touch the pad
  frictional ///< pressed on the recess's bottom and wall, both with the friction of steel on Ertalyte
};
constexpr auto choices(PadFoot) {
  return choices_of<PadFoot>({{PadFoot::tied, "tied"}, {PadFoot::frictional, "frictional"}});
}
struct ContactFriction {
  double steel_steel = 0.10;    ///< socket-cap [-]
  double steel_ertalyte = 0.07; ///< dish-pad [-]
  double rim = 0.0;             ///< slider-rim [-]
  /// At rest, where friction depends on speed (eq. 2-18) [-], at most the above; empty: it does not.
  std::optional<double> steel_steel_slow, steel_ertalyte_slow, rim_slow;
  double rate = 0; ///< of eq. (2-18) [s/m], > 0 where one of these is set
  /// p0 of the pad's friction by pressure, 0.7^(0.02 (p - p0)), p at the point itself in solids [Pa]; empty: it does
  /// not.
  std::optional<double> reference_pressure;
  PadFoot pad_foot = PadFoot::tied;
  double pad_clearance = 0; ///< between pad and recess wall, radial, where the seat is frictional [m], assumption
  bool operator==(const ContactFriction &) const = default;
};

/// Parts that may have a steel of their own, as [material.rim] beside [material.steel].
enum class SteelPart { rim, dish, slider };
constexpr auto choices(SteelPart) {
  using enum SteelPart;
  return choices_of<SteelPart>(
      {{rim, "rim", "the rim's wall"}, {dish, "dish", "the plate"}, {slider, "slider", "upper slider and foot"}});
}

/// Keys whose values are ours and not the user's or the source's. No dimension: bearings that differ in them alone are
/// equal.
struct AssumedKeys {
  std::set<std::string> keys; ///< as the bearing file writes them, dotted: "rim.height_mm"
  bool operator==(const AssumedKeys &) const { return true; }
};

struct Bearing {
  std::string name = "shfps-225";
  SurfaceSpec surface;
  UpperSlider slider;
  Rim rim;
  Plate plate;
  Pad pad;
  Foot foot;
  Material steel{200e9, 0.30, 7850.0, 360e6, 1450e6, 0.20};
  std::map<SteelPart, Material> part_steels = {}; ///< of the parts whose steel is another
  Material ertalyte{3.2e9, 0.30, 1390.0};
  ContactFriction contact;
  AssumedKeys assumed;

  const Material &steel_of(SteelPart part) const {
    const auto own = part_steels.find(part);
    return own == part_steels.end() ? steel : own->second;
  }
  const Material &rim_steel() const { return steel_of(SteelPart::rim); } ///< what the law of the rim is made of
  bool double_concave() const { return surface.concave == Concave::twice; }
  /// The slider between two dishes is two halves that slide on one another.
  bool has_interface() const { return double_concave() && slider.mu_interface.has_value(); }
  /// Below the slider, between foot and dish; a slider between two dishes has neither pad nor socket.
  bool has_pad() const { return !double_concave(); }
  /// Dishes in series, each moved through by its share of the travel: 1 or 2.
  int dishes() const { return double_concave() ? 2 : 1; }
  double wall_radius() const { return surface.planar_radius + rim.ledge; } ///< of the rim's inner face [m]
  /// Travel of what is carried at which the rim is touched, or both are [m]. L_c = r_p - b_s/2 (eq. 2-5); between two
  /// dishes C = R_eff sin(theta), theta the slider's tilt at which its rounded edge meets the wall.
  double lateral_capacity() const;
  /// What the carried mass rides: the dish, or the sphere of R_eff = 2 R - H_s (3-94) that two of them make, with the
  /// edge where twice the travel of one of them ends.
  SurfaceSpec ridden_surface() const;
  double pad_area() const;                                                       ///< [m^2]
  bool pad_is_seated() const { return contact.pad_foot == PadFoot::frictional; } ///< a body of its own, by friction
  double recess_radius() const;                                                  ///< of the wall around the pad [m]
  /// Throws InputError with both numbers for geometry that cannot be built or collides over 0..L_c of travel.
  void validate() const;
  /// The same of dish, slider, rim and materials alone: all that rung `rim` and the reduced models need of a bearing.
  void validate_rim() const;
  bool operator==(const Bearing &) const = default;
};

/// The bearing's steel and those of its parts, each with the table that has it, e.g. "rim".
std::vector<std::pair<std::string, Material *>> steels_of(Bearing &bearing);
std::vector<std::pair<std::string, const Material *>> steels_of(const Bearing &bearing);
/// Plastic strain that the steel of the rim's side, wall and plate, is trusted to, the lower of both [-]; none: not
/// judged.
std::optional<double> strain_limit(const Bearing &bearing);

/// An assumed key that this kind of bearing reads, with its value as the bearing file writes it, e.g. {"rim.height_mm",
/// "60"}.
struct Assumption {
  std::string key, value;
};
std::vector<Assumption> assumptions(const Bearing &bearing);

/// Tilt of the slider on the surface at travel r [rad] and the height its origin rises, between two dishes the height
/// that what it carries rises [m].
double tilt(const Bearing &bearing, double travel);
double lift(const Bearing &bearing, double travel);
/// Of the rim's top, and of the bottom of the slider's edge when it touches, above the dish's vertex [m].
double rim_top(const Bearing &bearing);
double edge_at_touch(const Bearing &bearing);
/// How far the slider may be lifted from its place at rest while its bottom stays below the rim's top [m]; infinite
/// where the dimensions leave the rim's top below it even at L_c (a scene that reads the dish alone).
double lift_over_rim(const Bearing &bearing);
/// Mass of the upper slider [kg]: cylinder less socket, or between its two faces; its edge taken as sharp. The
/// supported mass includes it.
double slider_mass(const Bearing &bearing);

} // namespace rimpact::scene

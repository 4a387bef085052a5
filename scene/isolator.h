/// [isolator]: a friction-pendulum bearing of rigid bodies between two spherical plates. A lens (DCFP); two lens halves
/// that meet in a plane, high-friction interface with a gap and a stop (LIR-DCFP; thesis Fig. 3-4); or two slide plates
/// with an inner slider between them (TFP; scene/triple_pendulum.h). SI units. Both plates are alike unless a `top_`
/// key says otherwise. It stands beside `Bearing`, which stays the single-dish bearing.
#pragma once
#include "io/files/choice.h"
#include "scene/choices.h"
#include "scene/impact_element.h"
#include <algorithm>
#include <optional>
#include <string>

namespace rimpact::scene {

/// In the plane x and z, two contact points a set or more on a line; or in space, on a circle.
enum class Space { planar, spatial };
constexpr auto choices(Space) {
  return choices_of<Space>({{Space::planar, "planar"}, {Space::spatial, "spatial"}});
}
/// What of the slider meets a plate's rim, in space.
enum class RimTouch { circle, points };
constexpr auto choices(RimTouch) {
  return choices_of<RimTouch>({{RimTouch::circle, "circle", "the slider's whole edge"},
                               {RimTouch::points, "points", "only where the contact points are"}});
}
/// Of the top plate.
enum class PlateRotation { fixed, free };
constexpr auto choices(PlateRotation) {
  return choices_of<PlateRotation>(
      {{PlateRotation::fixed, "fixed", "held by what it carries"}, {PlateRotation::free, "free"}});
}

/// The mass before the dashpots of rims, stop and contact points.
enum class DampedMass { supported, bearing };
constexpr auto choices(DampedMass) {
  return choices_of<DampedMass>(
      {{DampedMass::supported, "supported", "what the bearing carries, so that an impact returns e"},
       {DampedMass::bearing, "bearing",
        "the bearing's own parts, by (3-46); an impact of what it carries is nearly elastic"}});
}
/// Where the rim of a plate stands for a given capacity.
enum class RimPlace { exact, approximate };
constexpr auto choices(RimPlace) {
  return choices_of<RimPlace>({{RimPlace::exact, "exact", "touched at the capacity"},
                               {RimPlace::approximate, "approximate", "by (3-95), some mm farther out"}});
}

/// What the coefficients of friction of a TFP are of.
enum class FrictionOf { faces, loops };
constexpr auto choices(FrictionOf) {
  return choices_of<FrictionOf>({{FrictionOf::faces, "faces", "each point of the face, as for the other models"},
                                 {FrictionOf::loops, "loops",
                                  "force over load where the face begins to slide, as tests give it (Fenz and "
                                  "Constantinou 2008)"}});
}

/// Of a TFP, between the concave inner faces of its slide plates. The pivot is its middle.
struct InnerSlider {
  double radius = 0.076;                            ///< R_2 of its lower face [m], > diameter / 2
  std::optional<double> top_radius = {};            ///< R_3, where it differs [m]
  double bottom_height = 0.023, top_height = 0.023; ///< h_2, h_3: from the pivot to the face on the axis [m]
  double diameter = 0.051;                          ///< [m]
  double travel = 0.019;                            ///< d_2 along the lower slide plate's face to its rim [m], < R_2
  std::optional<double> top_travel = {};            ///< d_3, where it differs [m]
  double rim_height = 0.005;                        ///< of the slide plates' inner rims [m], > 0
  double mass = 0.5;                                ///< [kg], > 0
  double mu_fast = 0.02, mu_slow = 0.02;            ///< of its lower face [-]
  std::optional<double> top_mu_fast = {}, top_mu_slow = {}; ///< of its upper face, where it differs [-]
  bool own_rims = false; ///< the slide plates' rims have the element `rims`; else that of the plates, [reduced]'s
  ImpactElement rims = {};

  double upper_radius() const { return top_radius.value_or(radius); } ///< R_3 [m]
  double upper_travel() const { return top_travel.value_or(travel); } ///< d_3 [m]
  bool operator==(const InnerSlider &) const = default;
};

struct Isolator {
  std::string name;       ///< of the catalogue (isolator_catalogue.cc) whose numbers are the presets; empty: none
  double radius = 1.55;   ///< R of both sliding surfaces, or of the bottom one [m], > D_s/2
  double capacity = 0.30; ///< C_t: displacement at which both rims, or the bottom one, are touched [m], < R_eff
  std::optional<double> top_radius, top_capacity; ///< of the top plate, where it differs [m]
  std::optional<double> top_mu_slow,
      top_mu_fast;               ///< friction of the top plate, where it differs [-]; below: reduced.mu_*
  double slider_diameter = 0.30; ///< D_s; TFP: of the slide plates [m]
  double top_height = 0.07;      ///< h_ts, surface to interface on the axis; TFP: h_4, surface to pivot [m]
  double bottom_height = 0.03;   ///< h_bs; TFP: h_1 [m]. All sliders together are the sum of both high
  double top_wall = 0.04;        ///< e_ts [m]: the interface's radius is D_s/2 - e_ts
  double bottom_wall = 0.01;     ///< e_bs [m]: the stop's wall; gap = e_ts - e_bs
  double rim_height = 0.02;      ///< l of the plates' rims above the edge of the sliding surface [m], > 0
  double stop_height = 0.015;    ///< l_bs above the interface [m], > 0
  double slider_mass = 100.0;    ///< of the whole slider [kg], > 0; halves share it by height; TFP: of a slide plate
  double plate_mass = 300.0;     ///< m_tp of (3-46) [kg], > 0; read with the damped mass "bearing" only
  double mu_interface = 0.15;    ///< mu_s [-], constant in speed
  double travel = 0.064;         ///< TFP: d_1 along the bottom plate's surface to its rim [m], < R_1
  std::optional<double> top_travel = {}; ///< TFP: d_4, where it differs [m]
  FrictionOf mu_of = FrictionOf::faces;  ///< TFP
  InnerSlider inner;                     ///< TFP
  Space space = Space::planar;
  int points = 2;                    ///< contact points a set
  RimTouch rim = RimTouch::circle;   ///< read in space
  double contact_stiffness = 2e9;    ///< k of one contact point [N/m]
  double contact_restitution = 0.65; ///< of the contact's dashpot, (0, 1]
  DampedMass damped_mass = DampedMass::supported;
  RimPlace rim_place = RimPlace::exact;
  PlateRotation plate_rotation = PlateRotation::fixed; ///< free in space only
  double plate_inertia = 1000.0;                       ///< of the top plate and what turns with it [kg m^2], when free
  /// A dashpot's force begins at the touch, which ends no step there: at 1e-4 later peaks come out up to 6 % low, at
  /// 1e-5 within 0.3 %.
  double step_tolerance = 1e-5; ///< relative, of the time step's local error

  double slider_height() const { return top_height + bottom_height; }       ///< H_s; TFP: of all sliders
  double upper_radius() const { return top_radius.value_or(radius); }       ///< of the top plate's surface [m]
  double upper_capacity() const { return top_capacity.value_or(capacity); } ///< at which the top rim is touched [m]
  double upper_travel() const { return top_travel.value_or(travel); }       ///< d_4 [m]
  double effective_radius() const { return radius + upper_radius() - slider_height(); } ///< (3-94)
  /// Of a DCFP or LIR-DCFP: at which a rim is touched [m]; that of a TFP: triple_capacity.
  double lateral_capacity() const { return std::min(capacity, upper_capacity()); }
  double gap() const { return top_wall - bottom_wall; }
  double rim_tilt() const;       ///< theta_c = asin(C / R_eff), C the lateral capacity [rad]
  double edge_angle() const;     ///< phi = asin(D_s / 2R) of the bottom face [rad]
  double top_edge_angle() const; ///< of the top face [rad]
  /// m_s m_tp / (m_s + m_tp), the reduced mass of (3-46) [kg].
  double own_reduced_mass() const { return slider_mass * plate_mass / (slider_mass + plate_mass); }
  /// b/2 [m] of a plate's rim. Exact: b/2 = R sin(theta + phi), sin theta = C / R_eff, sin phi = D_s / 2R. Approximate,
  /// (3-95): b = C + D_s + H_s sin(theta).
  double bottom_rim_radius() const;
  double top_rim_radius() const;
  /// Throws InputError naming key, value and bound.
  void validate(ModelKind model) const;
  bool operator==(const Isolator &) const = default;
};

} // namespace rimpact::scene

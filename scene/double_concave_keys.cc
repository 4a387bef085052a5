#include "scene/keys.h"

namespace rimpact::scene {

namespace {

constexpr Range positive{0, huge, true};

/// What of the model is a choice between formulas.
void visit_readings(KeyVisitor &v, DoubleConcave &b) {
  v.choice({"damped_mass", "before the dashpots of rims, stop and contact points"}, b.damped_mass);
  if (v.wants(b.damped_mass == DampedMass::bearing))
    v.number({"plate_mass_kg", "m_tp of (3-46)"}, b.plate_mass, si, positive);
  v.choice({"rim_place", "of a plate, for the capacity"}, b.rim_place);
}

} // namespace

void visit(KeyVisitor &v, DoubleConcave &b, bool impact_resilient) {
  constexpr Range length_mm{0, 1e5, true}, size_mm{0, 1e5};
  v.number({"radius_m", "R of both sliding surfaces"}, b.radius, si, {0, 1e3, true});
  v.number({"capacity_m", "C_t: displacement at which the rims are touched"}, b.capacity, si, {0, 1e3, true});
  if (v.wants(b.top_radius.has_value()))
    v.limit({"top_radius_m", "R of the top plate; inf: as radius_m"}, b.top_radius, si, {0, 1e3, true});
  if (v.wants(b.top_capacity.has_value()))
    v.limit({"top_capacity_m", "displacement at which the top rim is touched; inf: as capacity_m"}, b.top_capacity, si,
            {0, 1e3, true});
  if (v.wants(b.top_mu_fast.has_value()))
    v.limit({"top_mu_fast", "of the top plate; inf: as reduced.mu_fast"}, b.top_mu_fast, si, {0, 2});
  if (v.wants(b.top_mu_slow.has_value()))
    v.limit({"top_mu_slow", "of the top plate; inf: as top_mu_fast, or as reduced.mu_slow"}, b.top_mu_slow, si, {0, 2});
  v.number({"slider_diameter_mm", "D_s"}, b.slider_diameter, milli, length_mm);
  v.number({"top_height_mm", "h_ts; a DCFP's slider is h_ts + h_bs high"}, b.top_height, milli, length_mm);
  v.number({"bottom_height_mm", "h_bs"}, b.bottom_height, milli, length_mm);
  if (v.wants(impact_resilient)) {
    v.number({"top_wall_mm", "e_ts; the gap is e_ts - e_bs"}, b.top_wall, milli, size_mm);
    v.number({"bottom_wall_mm", "e_bs"}, b.bottom_wall, milli, size_mm);
    v.number({"stop_height_mm", "l_bs, above the interface"}, b.stop_height, milli, length_mm);
    v.number({"mu_interface", "mu_s of the high-friction interface"}, b.mu_interface, si, {0, 2});
  }
  v.number({"rim_height_mm", "l, above the edge of the sliding surface"}, b.rim_height, milli, length_mm);
  v.number({"slider_mass_kg", "whole slider"}, b.slider_mass, si, positive);
  visit_readings(v, b);
  v.choice({"space"}, b.space);
  v.integer({"points", "contact points a set; a building's dish stands on as many"}, b.points, 2, 64);
  if (v.wants(b.space == Space::spatial)) {
    v.choice({"rim"}, b.rim);
    v.choice({"plate_rotation"}, b.plate_rotation);
  }
  if (v.wants(b.plate_rotation == PlateRotation::free))
    v.number({"plate_inertia_kg_m2", "what turns with the top plate"}, b.plate_inertia, si, positive);
  v.number({"contact_stiffness_kN_per_m", "of one contact point, also under a building's dish"}, b.contact_stiffness,
           kilo, positive);
  v.number({"contact_restitution", "of the contact's dashpot, also under a building's dish"}, b.contact_restitution, si,
           {0, 1, true});
  v.number({"step_tolerance", "relative, local error of a time step"}, b.step_tolerance, si, {1e-12, 1e-1});
}

} // namespace rimpact::scene

#include "scene/isolator_keys.h"

#include "scene/scene_keys.h"

namespace rimpact::scene {

namespace {

constexpr const char *dishes_on_springs = ", or dishes of a building stand on springs";

/// What of the model is a choice between formulas.
void visit_readings(KeyVisitor &v, Isolator &b, ModelKind model) {
  v.choice({"damped_mass", "before the dashpots of rims, stop and contact points"}, b.damped_mass);
  if (v.wants(b.damped_mass == DampedMass::bearing))
    v.number({"plate_mass_kg", "m_tp of (3-46)"}, b.plate_mass, si, positive);
  if (v.wants(model != ModelKind::tfp)) v.choice({"rim_place", "of a plate, for the capacity"}, b.rim_place);
}

/// Of a triple pendulum: how far the outer faces travel, and what friction is of.
void visit_triple(KeyVisitor &v, Isolator &b) {
  constexpr Range length_mm{0, 1e5, true};
  v.number({"travel_mm", "d_1, along the bottom plate's surface to its rim"}, b.travel, milli, length_mm);
  if (v.wants(b.top_travel.has_value()))
    v.limit({"top_travel_mm", "d_4, along the top plate's; inf: as travel_mm"}, b.top_travel, milli, length_mm);
  v.choice({"mu_of", "what every coefficient of friction is of"}, b.mu_of);
}

/// The slider in the middle of a triple pendulum.
void visit_inner(KeyVisitor &v, InnerSlider &in) {
  constexpr Range length_mm{0, 1e5, true};
  v.number({"radius_m", "R_2 of both faces of the inner slider"}, in.radius, si, {0, 1e3, true});
  if (v.wants(in.top_radius.has_value()))
    v.limit({"top_radius_m", "R_3 of its upper face; inf: as radius_m"}, in.top_radius, si, {0, 1e3, true});
  v.number({"bottom_height_mm", "h_2, from its middle to the lower face"}, in.bottom_height, milli, length_mm);
  v.number({"top_height_mm", "h_3, to the upper face"}, in.top_height, milli, length_mm);
  v.number({"diameter_mm", "of the inner slider"}, in.diameter, milli, length_mm);
  v.number({"travel_mm", "d_2, along the lower slide plate's face to its rim"}, in.travel, milli, length_mm);
  if (v.wants(in.top_travel.has_value()))
    v.limit({"top_travel_mm", "d_3, along the upper one's; inf: as travel_mm"}, in.top_travel, milli, length_mm);
  v.number({"rim_height_mm", "of the slide plates' rims, above the edge of their faces"}, in.rim_height, milli,
           length_mm);
  v.number({"mass_kg", "of the inner slider"}, in.mass, si, positive);
  v.number({"mu_fast", "friction of its lower face at speed"}, in.mu_fast, si, {0, 2});
  v.number({"mu_slow", "the same at rest"}, in.mu_slow, si, {0, 2});
  if (v.wants(in.top_mu_fast.has_value()))
    v.limit({"top_mu_fast", "of the upper face; inf: as mu_fast"}, in.top_mu_fast, si, {0, 2});
  if (v.wants(in.top_mu_slow.has_value()))
    v.limit({"top_mu_slow", "of the upper face; inf: as top_mu_fast, or as mu_slow"}, in.top_mu_slow, si, {0, 2});
  if (!v.wants(in.own_rims)) return;
  v.flag({"own_rims", "the slide plates' rims have the law of [isolator.inner.rims], not that of [reduced]"},
         in.own_rims);
  v.section("rims", [&] { visit(v, in.rims); });
}

/// Of the double concave models: displacements at which the rims are touched, and the interface.
void visit_double_concave(KeyVisitor &v, Isolator &b, bool interface) {
  constexpr Range length_mm{0, 1e5, true}, size_mm{0, 1e5};
  v.number({"capacity_m", "C_t: displacement at which the rims are touched"}, b.capacity, si, {0, 1e3, true});
  if (v.wants(b.top_capacity.has_value()))
    v.limit({"top_capacity_m", "displacement at which the top rim is touched; inf: as capacity_m"}, b.top_capacity, si,
            {0, 1e3, true});
  if (!v.wants(interface)) return;
  v.number({"top_wall_mm", "e_ts; the gap is e_ts - e_bs"}, b.top_wall, milli, size_mm);
  v.number({"bottom_wall_mm", "e_bs"}, b.bottom_wall, milli, size_mm);
  v.number({"stop_height_mm", "l_bs, above the interface"}, b.stop_height, milli, length_mm);
  v.number({"mu_interface", "mu_s of the high-friction interface"}, b.mu_interface, si, {0, 2});
}

/// Points of contact, and the steps they ask for.
void visit_contact(KeyVisitor &v, Isolator &b) {
  v.number({.name = "contact_stiffness_kN_per_m",
            .comment = "of one contact point, also under a building's dish",
            .counts_also = dishes_on_springs},
           b.contact_stiffness, kilo, positive);
  v.number({.name = "contact_restitution",
            .comment = "of the contact's dashpot, also under a building's dish",
            .counts_also = dishes_on_springs},
           b.contact_restitution, si, {0, 1, true});
  v.number(
      {.name = "step_tolerance", .comment = "relative, local error of a time step", .counts_also = dishes_on_springs},
      b.step_tolerance, si, {1e-12, 1e-1});
}

} // namespace

void visit(KeyVisitor &v, Isolator &b, ModelKind model) {
  using enum ModelKind;
  constexpr Range length_mm{0, 1e5, true};
  if (v.wants(!b.name.empty())) v.text({"name", "of the catalogue, whose numbers are the presets"}, b.name);
  v.number({"radius_m", "R of both sliding surfaces"}, b.radius, si, {0, 1e3, true});
  if (v.wants(b.top_radius.has_value()))
    v.limit({"top_radius_m", "R of the top plate; inf: as radius_m"}, b.top_radius, si, {0, 1e3, true});
  if (v.wants(model != tfp)) visit_double_concave(v, b, model != dcfp);
  if (v.wants(b.top_mu_fast.has_value()))
    v.limit({"top_mu_fast", "of the top plate; inf: as reduced.mu_fast"}, b.top_mu_fast, si, {0, 2});
  if (v.wants(b.top_mu_slow.has_value()))
    v.limit({"top_mu_slow", "of the top plate; inf: as top_mu_fast, or as reduced.mu_slow"}, b.top_mu_slow, si, {0, 2});
  if (v.wants(model == physical || model == tfp)) visit_triple(v, b);
  v.number({"slider_diameter_mm", "D_s; of a triple pendulum's slide plates"}, b.slider_diameter, milli, length_mm);
  v.number(
      {"top_height_mm", "h_ts, where all sliders are h_ts + h_bs high; of a triple pendulum h_4, surface to pivot"},
      b.top_height, milli, length_mm);
  v.number({"bottom_height_mm", "h_bs; of a triple pendulum h_1"}, b.bottom_height, milli, length_mm);
  v.number({"rim_height_mm", "l, above the edge of the sliding surface"}, b.rim_height, milli, length_mm);
  v.number({"slider_mass_kg", "whole slider; of a triple pendulum each slide plate"}, b.slider_mass, si, positive);
  visit_readings(v, b, model);
  v.choice({.name = "space", .meaning = "motion in a plane or in space"}, b.space);
  v.integer({.name = "points",
             .comment = "contact points a set; a building's dish stands on as many",
             .follows = "2; in space 8",
             .counts_also = dishes_on_springs},
            b.points, 2, 64);
  if (v.wants(b.space == Space::spatial)) {
    v.choice({"rim"}, b.rim);
    v.choice({"plate_rotation"}, b.plate_rotation);
  }
  if (v.wants(b.plate_rotation == PlateRotation::free))
    v.number({"plate_inertia_kg_m2", "what turns with the top plate"}, b.plate_inertia, si, positive);
  visit_contact(v, b);
  if (v.wants(model == physical || model == tfp)) v.section("inner", [&] { visit_inner(v, b.inner); });
}

} // namespace rimpact::scene

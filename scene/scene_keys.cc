#include "scene/scene_keys.h"

#include "io/files/error.h"
#include "scene/isolator_keys.h"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::scene {

void visit(KeyVisitor &v, ImpactElement &e) {
  laws::visit(v, e, e.impact_law);
  std::string read_before =
      e.calibration; // the folder is read, and its element put in the file's place, before the keys are
  if (v.wants(false)) v.text({"calibration", "folder to take law and numbers from"}, read_before);
  if (v.wants(!e.calibration.empty()))
    v.text({"taken_from", "calibration folder of the element; its numbers stand here"}, e.calibration);
  if (v.wants(e.fitted_from.has_value()))
    v.limit({"fitted_from_m_per_s", "slowest approach the element holds for"}, e.fitted_from, si, {0, 100});
  if (v.wants(e.fitted_to.has_value())) v.limit({"fitted_to_m_per_s", "fastest"}, e.fitted_to, si, {0, 100});
  if (v.wants(e.fitted_mass.has_value()))
    v.limit({"fitted_mass_kg", "supported mass it holds for"}, e.fitted_mass, si, positive);
  if (v.wants(e.fitted_speeds_mass.has_value()))
    v.limit({"fitted_speeds_mass_kg", "of a rim's own law: supported mass of those speeds; they move as 1/sqrt(m)"},
            e.fitted_speeds_mass, si, positive);
  if (v.wants(!e.foot_joint.empty()))
    v.text({"foot_joint", "what holds that rim on its plate; one piece, or not known, where it is left out"},
           e.foot_joint);
  if (v.wants(e.foot_force.has_value()))
    v.limit({"foot_force_kN", "of the rim, at which that joint goes: a run of a reduced model stops there"},
            e.foot_force, kilo, positive);
}

void visit(KeyVisitor &v, FittedPlates &p) {
  const auto known = [&](const Key &key, std::optional<double> &value, Unit unit) {
    if (v.wants(value.has_value())) v.limit(key, value, unit, positive);
  };
  known({"fitted_radius_m", "of the dishes of the double concave bearing it was fitted to"}, p.radius, si);
  known({"fitted_slider_height_mm", "of that bearing"}, p.slider_height, milli);
  known({"fitted_slider_diameter_mm", "of that bearing"}, p.slider_diameter, milli);
  known({"fitted_rim_height_mm", "of that bearing"}, p.rim_height, milli);
  known({"fitted_capacity_m", "of that bearing, both rims touched"}, p.capacity, si);
}

namespace {

constexpr Range not_negative{0, huge};
constexpr Range anything{-huge, huge};
constexpr Range share{0, 1};

void visit_pulse(KeyVisitor &v, Excitation &e) {
  using enum ExcitationKind;
  if (v.wants(e.kind == ricker || (e.kind == window && e.with_ground))) {
    v.number({"amplitude_g", "ground acceleration of the Ricker pulse (2-25)"}, e.amplitude_g, si, anything);
    v.number({"period_s", "T_p of the Ricker pulse"}, e.period, si, {1e-3, 1e5});
    v.number({.name = "centre_s", .comment = "instant of the pulse's peak", .follows = "2 period_s; of a window 0"},
             e.centre, si, {-1e5, 1e5});
  }
}

void visit_motion(KeyVisitor &v, Excitation &e) {
  using enum ExcitationKind;
  const auto is = [&](auto... kind) { return v.wants(((e.kind == kind) || ...)); };
  if (is(window))
    v.switches({"with", "what acts beside the impact: weight, friction, ground"},
               {{"weight", &e.with_weight}, {"friction", &e.with_friction}, {"ground", &e.with_ground}});
  visit_pulse(v, e);
  if (is(cyclic, figure_eight)) {
    v.number({"amplitude_m", "of the prescribed displacement"}, e.amplitude, si, {0, 1e3, true});
    v.number({"cycles", "of each amplitude"}, e.cycles, si, {0, 1e4, true});
  }
  if (is(cyclic) && v.wants(!e.amplitudes.empty()))
    v.numbers({"amplitudes_m", "several, one after the other; instead of amplitude_m"}, e.amplitudes, si,
              {0, 1e3, true});
  if (is(path)) v.text({"file", "CSV file of the path: x_m or x_mm, and if wanted y_m, time_s"}, e.path_file);
  if (is(push)) {
    v.number({"travel_mm", "of the push, beyond touch"}, e.travel, milli, {0, 1e4, true});
    v.flag({"return", "unload afterwards"}, e.unload);
  }
  if (is(window)) v.number({"speed_m_per_s", "approach speed"}, e.speed, si, {0, 100, true});
  if (is(ricker, cyclic, push, window))
    v.number({"direction_deg", "of motion, push or impact, in the plane, from x"}, e.direction_deg, si, {-360, 360});
  if (is(record)) {
    v.text(
        {"x", "record along x: a file of any form (FILE#2: its second channel), or a built-in one; empty: no motion"},
        e.x_file);
    v.text({"y", "record along y"}, e.y_file);
    v.text({"z", "record along z"}, e.z_file);
  }
  if (is(free)) {
    v.pair({"displacement_m", "initial displacement x, y"}, e.initial_displacement, {-1e3, 1e3});
    v.pair({"velocity_m_per_s", "initial velocity x, y"}, e.initial_velocity, {-1e3, 1e3});
  }
  if (v.wants(e.is_dynamic()))
    v.number({.name = "duration_s",
              .comment = "of the motion and of the run",
              .follows = "2 period_s + 6; of a window 0.2; of a record its length"},
             e.duration, si, {1e-6, 1e5});
}

/// Listed as a text: the reduced models are a catalogue (rimpact list models).
void visit_model(KeyVisitor &v, ModelKind &model) {
  std::string written = word(model);
  v.text({"model", "a reduced model of `rimpact list models`"}, written);
  if (const auto known = parse<ModelKind>(written))
    model = *known;
  else
    throw InputError(
        fmt::format("reduced.model \"{}\" is unknown; known: {}", written, fmt::join(words<ModelKind>(), ", ")));
}

void visit(KeyVisitor &v, ReducedSettings &r) {
  visit_model(v, r.model);
  visit(v, static_cast<ImpactElement &>(r));
  if (v.wants(r.capacity_offset != 0))
    v.number({"capacity_offset_mm", "the reduced rim begins at L_c plus this"}, r.capacity_offset, milli, {-100, 100});
  if (v.wants(!r.fitted_rim.empty())) v.text({"fitted_rim", "the rim it was fitted to"}, r.fitted_rim);
  visit(v, r.fitted_plates);
  v.choice({.name = "friction", .meaning = "law of friction; park-wen has an elastic slip"}, r.friction);
  v.number({"elastic_slip_mm", "of park-wen"}, r.elastic_slip, milli, {1e-3, 1e3});
  v.number(
      {.name = "mu_fast", .comment = "coefficient of friction at speed", .follows = "bearing.contact.steel_ertalyte"},
      r.mu_fast, si, {0, 2});
  v.number({.name = "mu_slow", .comment = "coefficient of friction at rest", .follows = "mu_fast"}, r.mu_slow, si,
           {0, 2});
  v.number({"rate_s_per_m", "of the velocity law"}, r.rate, si, {0, 1e6});
  visit(v, r.measured);
  v.choice({.name = "normal_force",
            .meaning = "inertia: with vertical inertia; static: by the slope; constant: W; pad: by the pad's spring"},
           r.normal_force);
  v.number({"vertical_restitution", "of coming back to the dish after uplift"}, r.vertical_restitution, si, share);
  v.flag({"finite_pad", "extra lift of the pad's finite size"}, r.finite_pad);
  v.flag({"socket_friction", "moment of the socket resisting tilt"}, r.socket_friction);
  v.number({"tolerance", "relative, of the integrator"}, r.tolerance, si, {1e-14, 1e-2});
  if (v.wants(r.integrator != Integrator::own))
    v.choice({.name = "integrator",
              .meaning = "own steps, or SUNDIALS CVODE as a check of them for one dish: the difference is printed"},
             r.integrator);
  v.number({"output_step_ms", "between stored samples outside contact"}, r.output_step, milli, {0, 1e4, true});
}

void visit(KeyVisitor &v, OwnMesh &m) {
  v.text({"file", ".msh, .geo or .step, instead of the built-in mesh"}, m.file);
  v.choice({"unit", "of the file's lengths: m | cm | mm | in"}, m.unit);
  v.number({"size_mm", "of cells meshed from .geo or .step"}, m.size, milli, {0, 1e3, true});
  v.number({"contact_size_mm", "of those where slider and rim meet"}, m.contact_size, milli, {0, 1e3, true});
  const bool renamed =
      std::any_of(m.groups.begin(), m.groups.end(), [](const std::string &name) { return !name.empty(); });
  if (!v.wants(renamed)) return;
  v.section("groups", [&] {
    for (std::size_t k = 0; k < m.groups.size(); ++k)
      if (v.wants(!m.groups[k].empty()))
        v.text({mesh_group_names[k], "what the file calls this part of the built-in mesh"}, m.groups[k]);
  });
}

} // namespace

void visit_settings(KeyVisitor &v, Scene &s) {
  v.section("load", [&] {
    v.number({.name = "vertical_kN", .comment = "dead load W", .follows = "m g where mass_kg is given, else 853"},
             s.load.vertical, kilo, not_negative);
    v.number({.name = "mass_kg",
              .comment = "inertia in all directions, a superstructure's included",
              .follows = "W / g where vertical_kN is given, else 86952"},
             s.load.mass, si, positive);
    v.number({"gravity_m_per_s2", "acceleration of gravity; records in g are multiplied by it"}, s.load.gravity, si,
             {0, 1e3, true});
  });
  v.section("excitation", [&] {
    v.choice({.name = "kind", .meaning = "what moves the bearing"}, s.excitation.kind);
    v.number({"scale", "multiplies any excitation"}, s.excitation.scale, si, {-1e6, 1e6});
    visit_motion(v, s.excitation);
  });
  v.section("model", [&] {
    v.choice({.name = "rung", .meaning = "which parts deform by finite elements"}, s.model.rung);
    v.integer({.name = "mesh",
               .comment = "1 | 2 | 3; 0: a draft, every size x 1.5",
               .meaning = "fineness, cells 1.5 times smaller a level; 0: a draft"},
              s.model.mesh, 0, 3);
    v.number({"step_ms", "inside an impact; 0: chosen by the plan"}, s.model.step, milli, {0, 1e3});
    v.number({"rho_inf", "spectral radius of generalised-alpha"}, s.model.rho_inf, si, share);
    v.number({"penalty_scale", "of contact, times the default"}, s.model.penalty_scale, si, {1e-4, 1e4});
    v.choice({.name = "symmetry", .meaning = "half: the motion is along x; auto: decided by the plan"},
             s.model.symmetry);
    if (v.wants(s.model.own_mesh.any())) v.section("own_mesh", [&] { visit(v, s.model.own_mesh); });
  });
  v.section("reduced", [&] { visit(v, s.reduced); });
  // Beside dishes too where it says something: a building's dishes may stand on its springs, and its "dcfp" are of it.
  if (v.wants(s.rigid_bodies() || s.isolator != Isolator()))
    v.section("isolator", [&] { visit(v, s.isolator, s.reduced.model); });
  if (v.wants(s.bounds != FrictionBounds())) v.section("bounds", [&] { visit(v, s.bounds); });
  v.section("superstructure", [&] { visit(v, s.superstructure); });
}

} // namespace rimpact::scene

#include "fe_contact/planning/refusal.h"
#include "fe_contact/planning/stack_plan.h"
#include "scene/solid_bearing.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace rimpact::planning {

namespace {

/// Of [reduced] what no rung reads, and would change what the user expects.
std::optional<std::string> unread_of_reduced(const scene::Scene &scene) {
  const auto &r = scene.reduced;
  if (r.integrator == scene::Integrator::cvode)
    return fmt::format("reduced.integrator \"{}\" checks the reduced model's own steps: finite elements have steps of "
                       "their own; use `rimpact reduced`, or --set reduced.integrator=\"own\"",
                       word(r.integrator));
  if (r.normal_force == scene::NormalForce::pad && r.calibration.empty()) // a calibration's is for its reduced model
    return fmt::format("reduced.normal_force \"{}\" is the reduced model's: rung `rim` has no pad, the others a solid "
                       "one or none; use `rimpact reduced`, or --set reduced.normal_force=\"{}\"",
                       word(r.normal_force), word(scene::NormalForce::inertia));
  if (r.measured.by_temperature)
    return "reduced.mu_by_temperature is the reduced models': the finite-element rungs carry no heat of sliding; use "
           "`rimpact reduced`, or --set reduced.mu_by_temperature=false";
  if (!has_dish(scene.model.rung)) return std::nullopt;
  const std::string solid = fmt::format(" is not for rung `{}`, whose pad or slider slides on its dish by the keys of "
                                        "bearing.contact: ",
                                        word(scene.model.rung));
  if (r.measured.table)
    return "reduced.mu_table" + solid + "steel_ertalyte, steel_ertalyte_slow, reference_pressure_MPa";
  if (r.measured.scale != 1) return "reduced.mu_scale" + solid + "steel_ertalyte, steel_ertalyte_slow";
  if (r.measured.reference_pressure != scene.bearing.contact.reference_pressure)
    return "reduced.mu_reference_pressure_MPa" + solid + "reference_pressure_MPa, the same for the reduced model";
  return std::nullopt;
}

} // namespace

std::optional<std::string> beyond_rungs(const scene::Scene &scene) {
  if (auto reason = scene::without_solid_bearing(scene, "the finite elements take")) return reason;
  if (scene.superstructure.any())
    return fmt::format("superstructure.kind \"{}\" is not for the finite-element rungs, which carry a rigid mass; use "
                       "`rimpact reduced`, or --set superstructure.kind=\"none\"",
                       word(scene.superstructure.kind));
  return unread_of_reduced(scene);
}

namespace {

/// The dishes ask for tan(phi) of the plane between the halves, sin(phi) = R sin(atan mu) / (R - H_s / 2).
std::optional<std::string> halves_that_slide_first(const scene::Bearing &b) {
  if (!b.has_interface()) return std::nullopt;
  constexpr double largest_mu = 2; // of the key
  const double R = b.surface.R0, mu = b.contact.steel_ertalyte, holds = *b.slider.mu_interface,
               sine = R * std::sin(std::atan(mu)) / (R - b.slider.height / 2),
               asked = sine < 1 ? std::tan(std::asin(sine)) : std::numeric_limits<double>::infinity();
  if (holds > asked) return std::nullopt;
  return fmt::format(
      "bearing.slider.mu_interface {:g} must be above {:.4g}, which the dishes ask of it "
      "(bearing.contact.steel_ertalyte {:g}): the halves would slide before the slider does; {}lower the "
      "friction of the dishes",
      holds, asked, mu, asked < largest_mu ? "raise it, or " : "");
}

/// A quasi-static path goes into the rims where the halves of the slider give way, and there alone.
std::optional<std::string> path_beyond_the_rim(const scene::Scene &scene) {
  const bool along_a_file = scene.excitation.kind == scene::ExcitationKind::path;
  if (const Plan plan = make_plan(scene); plan.rim_takes_part && !goes_into_the_rim(plan, scene.bearing))
    return fmt::format(
        "excitation.{} {:g} carries the slider to the rim, L_c = {:.6g} m; a quasi-static path must stay "
        "below it{}",
        along_a_file ? "file reaches" : "amplitude_m",
        scene.excitation.scale * (along_a_file ? scene.excitation.path.reach() : scene.excitation.largest_amplitude()),
        scene.bearing.lateral_capacity(),
        !scene.bearing.has_interface() ? std::string()
                                       : fmt::format(", or go beyond it along x, in a half model, by no more than "
                                                     "slider.interface_gap_mm {:g}",
                                                     1e3 * scene.bearing.slider.interface_gap));
  return std::nullopt;
}

} // namespace

std::optional<std::string> refusal(const scene::Scene &scene) {
  if (auto reason = beyond_rungs(scene)) return reason;
  using Kind = scene::ExcitationKind;
  const Kind kind = scene.excitation.kind;
  const bool stands = has_dish(scene.model.rung);
  const std::string rung = word(scene.model.rung), name = "excitation.kind '" + word(kind) + "'";
  const bool on_the_dish = scene.excitation.stays_on_dish();
  if (!stands && on_the_dish)
    return name +
           " moves on the dish without touching the rim; rung `rim` has nothing to solve there: try --rung rigid-dish";
  if (stands && kind == Kind::free)
    return name + " is not in this build's rung `" + rung +
           "`; it has: cyclic, figure-eight, path, push, ricker, record, window";
  if (stands && kind == Kind::window && !scene.excitation.with_weight)
    return std::string("a weightless window has nothing that holds the stack on its dish: set excitation.with to "
                       "[\"weight\", \"friction\"]") +
           (scene.bearing.has_interface() ? "" : ", or run it on rung `rim`");
  if (stands && scene.load.vertical <= 0)
    return fmt::format(
        "load.vertical_kN {:g} has nothing that holds the stack on its dish: rung `{}` needs a weight > 0{}",
        scene.load.vertical / 1e3, rung, scene.bearing.has_interface() ? "" : "; rung `rim` can do without");
  if (auto reason = halves_that_slide_first(scene.bearing)) return reason;
  if (!stands && scene.bearing.has_interface())
    return fmt::format("bearing.slider.mu_interface {:g} is not for rung `{}`, whose slider is one piece: try --rung "
                       "rigid-dish, or leave it out",
                       *scene.bearing.slider.mu_interface, rung);
  const double own = scene::slider_mass(scene.bearing);
  if (scene.load.mass <= own)
    return fmt::format("load.mass_kg {:g} is no more than the slider's own mass, {:.1f} kg, which it includes: nothing "
                       "is left to be carried",
                       scene.load.mass, own);
  return stands && on_the_dish ? path_beyond_the_rim(scene) : std::nullopt;
}

} // namespace rimpact::planning

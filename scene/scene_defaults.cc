#include "scene/scene_defaults.h"
#include "scene/assumptions.h"
#include "scene/bearing_catalogue.h"
#include "scene/flow_curve.h"
#include "scene/steel_defaults.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace rimpact::scene {
namespace {

/// What became of a tensile test's rows.
void remark_on_necking(Scene &scene) {
  for (const auto &[table, steel] : steels_of(std::as_const(scene.bearing))) {
    const bool inherited = steel != &scene.bearing.steel && steel->hardening == scene.bearing.steel.hardening;
    if (!steel->yield || steel->hardening.law != HardeningLaw::table || inherited) continue;
    const FlowCurve curve = flow_curve(*steel);
    if (curve.necks_at)
      scene.remarks.push_back(fmt::format(
          "the test piece of bearing.material.{}.curve necks at a strain of {:.3g}, where its stress is largest: the "
          "{} row(s) beyond are left out, for they are of no even strain. Beyond a plastic strain of {:.3g} the true "
          "stress is held at {:.4g} MPa",
          table, *curve.necks_at, curve.n_cut, curve.rows.back()[0], curve.rows.back()[1] / 1e6));
  }
}

/// A socket as deep and wide, for its slider, as the built-in bearing's.
void resolve_socket(Bearing &b) {
  constexpr double depth = 0.3175, width = 0.57; // of the slider's height and radius
  const double bottom = b.slider.bottom, radius = b.slider.diameter / 2, cap = b.foot.cap_radius;
  const bool fits =
      cap > bottom && cap < b.slider.top && std::sqrt(cap * cap - bottom * bottom) < radius - b.slider.edge_radius;
  if (!fits && b.slider.top > bottom)
    b.foot.cap_radius = std::min(bottom + depth * (b.slider.top - bottom), std::hypot(bottom, width * radius));
}

/// Whether a built-in bearing has the same dish and slider and, where `wholly`, is the same in everything but its name.
bool is_builtin(Bearing bearing, bool wholly) {
  const auto names = builtin_bearing_names();
  return std::any_of(names.begin(), names.end(), [&](const std::string &name) {
    const Bearing known = builtin_bearing(name);
    bearing.name = name;
    return wholly ? bearing == known
                  : bearing.surface == known.surface && bearing.slider.diameter == known.slider.diameter;
  });
}

/// Another bearing than the built-in ones carries the thesis's load for want of its own: that is remarked upon.
void resolve_load(const TomlFile &file, bool own_bearing, Scene &scene) {
  const char *weight_key = "load.vertical_kN", *mass_key = "load.mass_kg";
  const bool weight = file.find(weight_key), mass = file.find(mass_key);
  Load &load = scene.load;
  if (weight && !mass && load.vertical > 0) load.mass = load.vertical / load.gravity;
  if (mass && !weight) load.vertical = load.mass * load.gravity;
  if ((weight && !is_marked(file, weight_key)) || (mass && !is_marked(file, mass_key))) return;
  const bool given = weight || mass;
  scene.load_remark =
      given
          ? fmt::format("load.vertical_kN and load.mass_kg are marked in {}: {}", file.origin(), assumed_load)
          : fmt::format("load.vertical_kN and load.mass_kg are not given: bearing {} carries the thesis's {:g} kN and "
                        "{:g} kg (one of the two keys is enough: W = m g), {}",
                        scene.bearing.name, load.vertical / 1e3, load.mass, assumed_load);
  if (!given && !scene.rigid_bodies() && !is_builtin(scene.bearing, own_bearing))
    scene.remarks.push_back(scene.load_remark);
}

/// The plates of rigid bodies are not the dish of [bearing].
void remark_on_isolator(const TomlFile &file, Scene &scene) {
  if (!scene.rigid_bodies() || file.find("isolator")) return;
  const std::string taken = scene.triple() ? scene.isolator.name + " of the catalogue, of" : "the thesis's of";
  scene.remarks.push_back(
      fmt::format("no [isolator] is given: reduced.model \"{}\" takes {} R_eff = {:g} m and C_t = {:.4g} mm, an "
                  "assumption{}",
                  word(scene.reduced.model), taken, scene.isolator.effective_radius(), 1e3 * scene.lateral_capacity(),
                  file.find("bearing") ? fmt::format("; nothing of bearing {} is read", scene.bearing.name) : ""));
}

/// What solids slide by, and what a pad loses, stands in two places: what a run does not read of them is said.
void remark_on_pad(Scene &scene) {
  const double slides_by = scene.bearing.contact.steel_ertalyte, eta = scene.bearing.pad.loss_factor;
  const bool solid = has_dish(scene.model.rung), has_pad = scene.bearing.has_pad();
  if (solid && !scene.reduced.measured.table && std::abs(scene.reduced.mu_fast - slides_by) > 1e-12)
    scene.remarks.push_back(
        fmt::format("reduced.mu_fast {:g} is not read by rung `{}`, but by the reduced model and the "
                    "scout: its {} slides by bearing.contact.steel_ertalyte {:g}",
                    scene.reduced.mu_fast, word(scene.model.rung), has_pad ? "pad" : "slider", slides_by));
  if (has_pad && !solid && eta > 0 && scene.reduced.normal_force != NormalForce::pad)
    scene.remarks.push_back(fmt::format("bearing.pad.loss_factor {:g} is not read: the reduced model has a pad with "
                                        "reduced.normal_force \"{}\", finite elements with rungs `rigid-dish` and "
                                        "`full`",
                                        eta, word(NormalForce::pad)));
}

void remark_on_interface(Scene &scene) {
  if (scene.rigid_bodies() || !scene.bearing.has_interface()) return;
  scene.remarks.push_back(fmt::format(
      "bearing.slider.mu_interface {:g} is read by rungs `rigid-dish` and `full`: to the reduced model and the scout "
      "the slider is one piece; reduced.model \"{}\" takes an interface from [isolator]",
      *scene.bearing.slider.mu_interface, word(ModelKind::lir_dcfp)));
}

} // namespace

void set_dependent_defaults(const TomlFile &file, const std::string &prefix, Bearing &bearing) {
  resolve_steel(file, prefix, {bearing.steel, "material.steel.", bearing.rim.thickness}, bearing.assumed);
  resolve_slope(file, prefix + "material.ertalyte.", bearing.ertalyte);
  if (bearing.surface.kind == SurfaceKind::sphere) bearing.surface.a = bearing.surface.R0;
  const std::string cap = "foot.cap_radius_mm";
  if (!file.find(prefix + cap) && bearing.assumed.keys.count(cap) > 0) resolve_socket(bearing);
}

void set_dependent_defaults(const TomlFile &file, bool own_bearing, Scene &scene) {
  auto &e = scene.excitation;
  const auto given = [&](const char *path) { return file.find(path) != nullptr; };
  const bool window = e.kind == ExcitationKind::window;
  if (!given("excitation.centre_s")) e.centre = window ? 0.0 : 2 * e.period;
  if (!given("excitation.duration_s")) {
    e.duration = window ? 0.2 : 2 * e.period + 6;
    const bool has_record = !e.x.values.empty() || !e.y.values.empty() || !e.z.values.empty();
    if (e.kind == ExcitationKind::record && has_record) e.duration = std::max({e.x.end(), e.y.end(), e.z.end()});
  }
  if (!given("excitation.amplitude_m") && e.kind == ExcitationKind::figure_eight) e.amplitude = 0.31;
  if (!given("isolator.points") && scene.isolator.space == Space::spatial) scene.isolator.points = 8;
  if (!given("isolator.inner.mu_slow") && given("isolator.inner.mu_fast"))
    scene.isolator.inner.mu_slow = scene.isolator.inner.mu_fast;
  if (!given("reduced.mu_fast")) scene.reduced.mu_fast = scene.bearing.contact.steel_ertalyte;
  const auto &contact = scene.bearing.contact;
  const bool as_solid =
      contact.steel_ertalyte_slow && !given("reduced.mu_fast"); // friction over speed is the bearing's
  if (!given("reduced.mu_slow"))
    scene.reduced.mu_slow = as_solid ? *contact.steel_ertalyte_slow : scene.reduced.mu_fast;
  if (!given("reduced.rate_s_per_m") && as_solid) scene.reduced.rate = contact.rate;
  auto &measured = scene.reduced.measured;
  if (!given("reduced.mu_fast") && !given("reduced.mu_reference_pressure_MPa") && !measured.table)
    measured.reference_pressure = contact.reference_pressure;
  resolve_load(file, own_bearing, scene);
  remark_on_necking(scene);
  remark_on_pad(scene);
  remark_on_interface(scene);
  remark_on_isolator(file, scene);
  if (!given("excitation.kind"))
    scene.remarks.push_back(
        fmt::format("{} has no excitation.kind: a Ricker pulse of {:g} g and {:g} s is run, on bearing {}",
                    file.origin(), e.scale * e.amplitude_g, e.period, scene.bearing_name()));
}

} // namespace rimpact::scene

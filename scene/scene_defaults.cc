#include "scene/scene_defaults.h"
#include "scene/assumptions.h"
#include "scene/bearing_catalogue.h"
#include "scene/flow_curve.h"
#include "scene/steel_grades.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

/// Material keys that hang together: no yield, no slope past it; yield alone is perfectly plastic.
void settle(const TomlFile &file, const std::string &prefix, Material &m) {
  const std::string key = prefix + "tangent_modulus_MPa";
  if (!m.yield || m.hardening.law != HardeningLaw::bilinear)
    m.tangent_modulus.reset();
  else if (!m.tangent_modulus && file.find(key))
    throw InputError(fmt::format("{}: {} inf must be below E_MPa {:g}", file.location(key), key, m.E / 1e6));
  else if (!m.tangent_modulus)
    m.tangent_modulus = 0.0;
}

/// Marks a number of the steel that the file leaves out: an assumption, or not.
void mark(Bearing &b, const std::string &key, bool assumed) {
  const std::string path = "material.steel." + key;
  if (assumed)
    b.assumed.keys.insert(path);
  else
    b.assumed.keys.erase(path);
}

/// What a grade gives and the file does not. The thickness is the rim's.
void settle_grade(const TomlFile &file, const std::string &prefix, Bearing &b) {
  Material &steel = b.steel;
  const std::string table = prefix + "material.steel.";
  const auto given = [&](const std::string &key) { return file.find(table + key) != nullptr; };
  if (!given("grade") || !steel.has_grade()) return;
  const SteelGrade &grade = steel_grade(steel.grade);
  Material named = steel;
  try {
    named = steel_of(grade, b.rim.thickness, given("yield_MPa") || given("hardness_HB") ? steel.yield : std::nullopt);
  } catch (const InputError &error) {
    throw InputError(
        fmt::format("{}: {}grade \"{}\": {}", file.location(table + "grade"), table, grade.name, error.what()));
  }
  const auto take = [&](const char *key, auto &target, const auto &value) {
    if (!given(key)) target = value;
  };
  take("E_MPa", steel.E, named.E), take("nu", steel.nu, named.nu);
  take("density_kg_per_m3", steel.density, named.density), take("yield_MPa", steel.yield, named.yield);
  take("strain_limit", steel.strain_limit, named.strain_limit);
  take("rate_D_per_s", steel.rate.D, named.rate.D), take("rate_q", steel.rate.q, named.rate.q);
  take("fracture_D1", steel.fracture.D1, named.fracture.D1), take("fracture_D2", steel.fracture.D2, named.fracture.D2);
  take("fracture_D3", steel.fracture.D3, named.fracture.D3);
  for (const auto &[key, number] : grade.numbers)
    if (const bool estimated = key == "yield_MPa" && given("hardness_HB");
        !given(key) && !is_of_the_curve(key) && !estimated)
      mark(b, key, !number.checked);
  if (given("hardening") || given("curve") || given("tangent_modulus_MPa")) return;
  steel.hardening.law = named.hardening.law;
  take("hardening_Q_MPa", steel.hardening.Q, named.hardening.Q),
      take("hardening_b", steel.hardening.b, named.hardening.b);
  for (const char *key : {"hardening_Q_MPa", "hardening_b"})
    if (!given(key)) mark(b, key, true); // of an estimated curve
}

/// The yield stress estimated from a hardness, where it is not given.
void settle_hardness(const TomlFile &file, const std::string &prefix, Bearing &b) {
  Material &steel = b.steel;
  const std::string key = prefix + "material.steel.hardness_HB", yield = prefix + "material.steel.yield_MPa";
  if (!file.find(key)) return;
  const double estimate = yield_of_hardness(steel.hardness_HB);
  constexpr double rounding = 1e-3;
  if (file.find(yield) && (!steel.yield || std::abs(*steel.yield / estimate - 1) > rounding))
    throw InputError(fmt::format("{}: {} {:g} stands beside yield_MPa, which it would estimate at {:.0f}; give one",
                                 file.location(key), key, steel.hardness_HB, estimate / 1e6));
  if (file.find(yield)) return;
  steel.yield = estimate;
  mark(b, "yield_MPa", true);
}

/// The law of hardening, and the yield stress where its curve has one of its own. A curve alone chooses `table`.
void settle_hardening(const TomlFile &file, const std::string &prefix, Bearing &b) {
  Material &steel = b.steel;
  const std::string key = prefix + "material.steel.", curve = key + "curve", yield = "material.steel.yield_MPa";
  if (file.find(curve) && !file.find(key + "hardening")) steel.hardening.law = HardeningLaw::table;
  if (!steel.yield) return;
  std::optional<double> own;
  try {
    check_hardening("steel", steel);
    own = yield_of_curve(steel);
  } catch (const InputError &error) {
    throw InputError(fmt::format("{}: {}", file.location(file.find(curve) ? curve : key + "hardening"), error.what()));
  }
  if (!own) return;
  if (file.find(key + "hardness_HB"))
    throw InputError(fmt::format("{}: {}hardness_HB stands beside a curve, which has a yield stress of its own, "
                                 "{:g} MPa; give one",
                                 file.location(key + "hardness_HB"), key, *own / 1e6));
  constexpr double rounding = 1e-3;
  if (!file.find(prefix + yield))
    mark(b, "yield_MPa", is_marked(file, curve));
  else if (std::abs(*steel.yield / *own - 1) > rounding)
    throw InputError(fmt::format("{}: {} {:g} is not the {:g} MPa that the curve of hardening \"{}\" begins at; leave "
                                 "it out",
                                 file.location(prefix + yield), prefix + yield, *steel.yield / 1e6, *own / 1e6,
                                 word(steel.hardening.law)));
  steel.yield = own;
}

/// What became of a tensile test's rows.
void remark_on_necking(Scene &scene) {
  const Material &steel = scene.bearing.steel;
  if (!steel.yield || steel.hardening.law != HardeningLaw::table) return;
  const FlowCurve curve = flow_curve(steel);
  if (curve.necks_at)
    scene.remarks.push_back(fmt::format(
        "the test piece of bearing.material.steel.curve necks at a strain of {:.3g}, where its stress is largest: the "
        "{} row(s) beyond are left out, for they are of no even strain. Beyond a plastic strain of {:.3g} the true "
        "stress is held at {:.4g} MPa",
        *curve.necks_at, curve.n_cut, curve.rows.back()[0], curve.rows.back()[1] / 1e6));
}

/// A socket as deep and wide, for its slider, as the built-in bearing's.
void settle_socket(Bearing &b) {
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
void settle_load(const TomlFile &file, bool own_bearing, Scene &scene) {
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

} // namespace

void set_dependent_defaults(const TomlFile &file, const std::string &prefix, Bearing &bearing) {
  settle_hardness(file, prefix, bearing);
  settle_grade(file, prefix, bearing);
  settle_hardening(file, prefix, bearing);
  settle(file, prefix + "material.steel.", bearing.steel);
  settle(file, prefix + "material.ertalyte.", bearing.ertalyte);
  if (bearing.surface.kind == SurfaceKind::sphere) bearing.surface.a = bearing.surface.R0;
  const std::string cap = "foot.cap_radius_mm";
  if (!file.find(prefix + cap) && bearing.assumed.keys.count(cap) > 0) settle_socket(bearing);
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
  settle_load(file, own_bearing, scene);
  remark_on_necking(scene);
  remark_on_isolator(file, scene);
  if (!given("excitation.kind"))
    scene.remarks.push_back(
        fmt::format("{} has no excitation.kind: a Ricker pulse of {:g} g and {:g} s is run, on bearing {}",
                    file.origin(), e.scale * e.amplitude_g, e.period, scene.bearing.name));
}

} // namespace rimpact::scene

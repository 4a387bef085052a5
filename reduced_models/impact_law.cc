#include "reduced_models/impact_law.h"
#include "files/error.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace rimpact::reduced {

namespace {

// Kelvin-Voigt with the radial rate. Bilateral it pulls while separating until the penetration ends, and
// returns e exactly; unilateral it never pulls.
ImpactForce kelvin_voigt(const RimElement &r, const RimMotion &m) {
  return {r.stiffness * m.d + r.damping * m.rate, r.stiffness, r.damping};
}

// (2-21) to the letter: c times the planar speed whatever its direction, so that the dashpot gives back in
// separation what it took in approach (rebound 1.000 for every e).
ImpactForce printed_law(const RimElement &r, const RimMotion &m) {
  return {r.stiffness * m.d + r.damping * m.speed, r.stiffness, 0, r.damping};
}

// Hunt and Crossley (1975): damping grows with the penetration, so that the force starts and ends at zero
// and the restitution falls with speed. K = k_i d_1 / d_1^n, d_1 = 1 mm.
ImpactForce hunt_crossley(const RimElement &r, const RimMotion &m) {
  const double damped = 1 + r.dissipation * m.rate;
  if (m.d <= 0 || damped <= 0) return {0, 0, 0};
  const double spring = r.stiffness * hunt_crossley_penetration * std::pow(m.d / hunt_crossley_penetration, r.exponent);
  return {spring * damped, r.exponent * spring / m.d * damped, spring * r.dissipation};
}

// A dent spreads as it deepens, so the rim hardens less than linearly (p < 1). Rate-independent: along the backbone to
// the deepest penetration, from and to it along the curve of unloading; below that the force by which the law is from
// pressing.
ImpactForce elastoplastic(const RimElement &r, const RimMotion &m) {
  if (!(m.deepest > 0) && m.d < 0) return {r.stiffness * m.d, r.stiffness, 0};
  if (m.d >= m.deepest) return elastoplastic_backbone(r, m.d);
  const Unloading back = unloading(r, m.deepest);
  const double s = 1 - (m.deepest - m.d) / back.length, bend = back.curvature * std::max(0.0, s),
               slope = back.top / back.length;
  return {back.top * s * (1 - back.curvature + bend), slope * (1 - back.curvature + 2 * bend), 0};
}

// As pushed by finite elements: along the loading to the deepest penetration, from and to it along the unloading.
ImpactForce pushed_curve(const RimElement &r, const RimMotion &m) {
  const RimCurve::Force f =
      m.deepest > 0 && m.d < m.deepest ? r.curve->unloading(m.d, m.deepest) : r.curve->loading(m.d);
  return {f.force, f.slope, 0};
}

} // namespace

const std::vector<ImpactLaw> &impact_laws() {
  static const std::vector<ImpactLaw> laws = {
      {"signed",
       "k d + c d' with the radial rate until the penetration ends; returns e exactly",
       {"k_i", "e"},
       {},
       kelvin_voigt,
       false,
       false},
      {"no-tension",
       "max(0, k d + c d'): never pulls; rebound 0.675 for e = 0.65",
       {"k_i", "e"},
       {},
       kelvin_voigt,
       true,
       false},
      {"printed",
       "(2-21) as printed, k d + c |v|: rebound 1.000 for every e",
       {"k_i", "e"},
       {},
       printed_law,
       false,
       false},
      {"hunt-crossley",
       "K d^n (1 + chi d'): damping grows with penetration, rebound falls with speed",
       {"k_i", "e", "exponent"},
       {},
       hunt_crossley,
       false,
       false},
      {"elastoplastic",
       "yielding rim: softening load path, stiffer unloading, dents that stay",
       {"k_i", "yield_force", "hardening", "unloading_gain"},
       {"hardening_exponent", "unloading_exponent"},
       elastoplastic,
       true,
       true},
      {"curve",
       "the bearing's own rim, pushed once by finite elements (rimpact curve)",
       {},
       {},
       pushed_curve,
       true,
       true},
  };
  return laws;
}

const ImpactLaw &impact_law(const std::string &name) {
  std::string known;
  for (const auto &law : impact_laws()) {
    if (law.name == name) return law;
    known += (known.empty() ? "" : ", ") + law.name;
  }
  throw InputError("reduced.impact_law \"" + name + "\" is unknown; known: " + known);
}

bool ImpactLaw::reads(const std::string &parameter) const {
  const auto among = [&](const std::vector<std::string> &names) {
    return std::find(names.begin(), names.end(), parameter) != names.end();
  };
  return among(parameters) || among(exponents);
}

ImpactForce RimElement::at(const RimMotion &motion) const {
  const ImpactForce f = law->at(*this, motion);
  return law->unilateral && f.force <= 0 ? ImpactForce{0, 0, 0} : f;
}

RimElement rim_element(const scene::ReducedSettings &s, double mass) {
  const ImpactLaw &law = impact_law(s.impact_law);
  if (law.at == pushed_curve)
    throw InputError("reduced.impact_law \"curve\" has no numbers: it flies on the curve of a bearing's rim, by the "
                     "reduced model physical only");
  const bool hunt = law.at == hunt_crossley; // others leave its reference speed unread
  return {.stiffness = s.k_i,
          .damping = damping_coefficient(s.k_i, s.restitution, mass),
          .exponent = s.impact_exponent,
          .dissipation = hunt ? hunt_crossley_dissipation(s.restitution, s.reference_speed) : 0,
          .yield_force = s.yield_force,
          .hardening = s.hardening,
          .hardening_exponent = s.hardening_exponent,
          .unloading_gain = s.unloading_gain,
          .unloading_exponent = s.unloading_exponent,
          .law = &law};
}

RimElement curve_element(std::shared_ptr<const RimCurve> curve) {
  const double stiffness = curve->loading(0).slope;
  return {.stiffness = stiffness, .law = &impact_law("curve"), .curve = std::move(curve)};
}

double damping_ratio(double restitution) {
  if (!(restitution > 0 && restitution <= 1))
    throw InputError("reduced.restitution " + std::to_string(restitution) + " is outside (0, 1]");
  const double ln = std::log(restitution);
  return -ln / std::hypot(std::numbers::pi, ln);
}

double damping_coefficient(double stiffness, double restitution, double mass) {
  return 2 * damping_ratio(restitution) * std::sqrt(stiffness * mass);
}

double hunt_crossley_dissipation(double e, double speed) {
  if (!(e > 0 && e <= 1)) throw InputError("reduced.restitution " + std::to_string(e) + " is outside (0, 1]");
  if (!(speed > 0)) throw InputError("reduced.reference_speed_m_per_s " + std::to_string(speed) + " must be > 0");
  if (e == 1) return 0;
  // taken minus given back is positive for small a and falls without bound towards a = 1 / e
  double low = 0, high = 1 / e;
  while (high - low > 1e-15 * high) {
    const double a = (low + high) / 2;
    if (a <= low || a >= high) break;
    (a - std::log1p(a) + e * a + std::log1p(-e * a) > 0 ? low : high) = a;
  }
  return low / speed;
}

// The knee is that of Menegotto and Pinto (1973) with exponent 2.
ImpactForce elastoplastic_backbone(const RimElement &r, double d) {
  const double p = r.hardening_exponent, h = r.hardening, x = r.stiffness * d / r.yield_force, knee = (1 - h) * x,
               root = std::sqrt(1 + knee * knee);
  return {r.yield_force * (knee / root + h / p * (std::pow(1 + x, p) - 1)),
          r.stiffness * ((1 - h) / (root * root * root) + h * std::pow(1 + x, p - 1)), 0};
}

Unloading unloading(const RimElement &r, double deepest) {
  const double top = elastoplastic_backbone(r, deepest).force,
               slope = r.stiffness *
                       (1 + r.unloading_gain * std::pow(r.stiffness * deepest / r.yield_force, r.unloading_exponent)),
               w = std::min(opening, slope * deepest / top - 1);
  return {top, w, (1 + w) * top / slope};
}

double residual_indentation(const RimElement &r, double deepest) {
  return deepest - unloading(r, deepest).length;
}

double kelvin_voigt_peak(double restitution) {
  const double xi = damping_ratio(restitution);
  if (xi >= 0.5) return 2 * xi; // the force is largest at touch
  const double root = std::sqrt(1 - xi * xi);
  const double angle = std::atan2(root * (1 - 4 * xi * xi), xi * (3 - 4 * xi * xi));
  return std::exp(-xi / root * angle);
}

} // namespace rimpact::reduced

#include "laws/impact/hunt_crossley.h"

#include "io/files/error.h"
#include "laws/impact/catalogue.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact::laws {
namespace {

ImpactForce hunt_crossley_force(const RimElement &r, const RimMotion &m) {
  const double damped = 1 + r.dissipation * m.rate;
  if (m.d <= 0 || damped <= 0) return {0, 0, 0};
  const double n = r.impact_exponent;
  const double spring = r.stiffness * hunt_crossley_penetration * std::pow(m.d / hunt_crossley_penetration, n);
  return {spring * damped, n * spring / m.d * damped, spring * r.dissipation};
}

void set_dissipation(RimElement &r, double) {
  r.dissipation = hunt_crossley_dissipation(r.restitution, r.reference_speed);
}

std::vector<std::pair<std::string, double>> spring_and_dissipation(const RimElement &r) {
  return {{"stiffness_N_per_m", r.stiffness}, {"exponent", r.impact_exponent}, {"dissipation_s_per_m", r.dissipation}};
}

OpenSeesMaterial hertzdamp(const RimElement &r) {
  return {.material = RimMaterial::hertzdamp,
          .numbers = {{"K_h", r.stiffness * std::pow(hunt_crossley_penetration, 1 - r.impact_exponent), "N/m^n"},
                      {"xi_norm", r.dissipation * r.reference_speed, "chi times the reference speed"},
                      {"exponent", r.impact_exponent, "n"}},
          .notes = {fmt::format("Rim: Hertzdamp is the law at {:g} m/s; its damping is normalised by each impact's own "
                                "speed, so that the restitution stays where the law's falls with speed.",
                                r.reference_speed),
                    "rim_springs: two along x, blind to y. No dents."}};
}

void visit_hunt_crossley(KeyVisitor &v, LawNumbers &n, const ImpactLaw &) {
  v.number({"impact_exponent", "n of K d^n (1 + chi d')"}, n.impact_exponent, si, {0, 10, true});
  v.number({"reference_speed_m_per_s", "approach speed at which the restitution holds"}, n.reference_speed, si,
           {0, 100, true});
}

} // namespace

const LawFamily &hunt_crossley_laws() {
  static const LawFamily family{
      .laws = {{.name = "hunt-crossley",
                .description = "K d^n (1 + chi d'): damping grows with penetration, rebound falls with speed",
                .parameters = {"k_i", "e", "exponent"},
                .exponents = {},
                .at = hunt_crossley_force,
                .needs = {"k_i_kN_per_m", "restitution", "impact_exponent", "reference_speed_m_per_s"},
                .prepare = set_dissipation,
                .numbers = spring_and_dissipation,
                .opensees = hertzdamp}},
      .parameters = {{"exponent", "-", "impact_exponent", 1, 0.2, 4.0, true, &LawNumbers::impact_exponent}},
      .visit = visit_hunt_crossley};
  return family;
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

} // namespace rimpact::laws

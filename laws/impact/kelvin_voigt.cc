#include "laws/impact/kelvin_voigt.h"

#include "io/files/error.h"
#include "laws/impact/catalogue.h"
#include <cmath>
#include <numbers>

namespace rimpact::laws {
namespace {

// Kelvin-Voigt with the radial rate. Bilateral it pulls while separating until the penetration ends, and
// returns e exactly; unilateral it never pulls.
ImpactForce radial_rate(const RimElement &r, const RimMotion &m) {
  return {r.stiffness * m.d + r.damping * m.rate, r.stiffness, r.damping};
}

// (2-21) to the letter: c times the planar speed whatever its direction, so that the dashpot gives back in
// separation what it took in approach (rebound 1.000 for every e).
ImpactForce planar_speed(const RimElement &r, const RimMotion &m) {
  return {r.stiffness * m.d + r.damping * m.speed, r.stiffness, 0, r.damping};
}

void set_damping(RimElement &r, double mass) {
  r.damping = damping_coefficient(r.stiffness, r.restitution, mass);
}

std::vector<std::pair<std::string, double>> spring_and_dashpot(const RimElement &r) {
  return {{"stiffness_N_per_m", r.stiffness}, {"damping_N_s_per_m", r.damping}};
}

OpenSeesMaterial dashpot_behind_a_gap(const RimElement &r) {
  return {.material = RimMaterial::viscoelastic_gap,
          .numbers = {{"k_i", r.stiffness, "N/m"}, {"c_i", r.damping, "N s/m, 2 xi sqrt(k_i m1), m2 infinite"}},
          .notes = {r.law->unilateral
                        ? "Rim: a gap that only presses, in series with spring and dashpot: it never pulls, "
                          "as the law (ViscoelasticGap would)."
                        : "Rim: ViscoelasticGap is the law itself; it pulls just before release.",
                    "rim_springs: two along x, blind to y: OpenSees has no round gap with a dashpot. Turn x along the "
                    "motion, or export a law of the rim (elastoplastic)."}};
}

void visit_pair(KeyVisitor &v, LawNumbers &n, const ImpactLaw &) {
  v.number({"k_i_kN_per_m", "impact stiffness; 0: no impact element"}, n.k_i, kilo, {0, huge});
  v.number({"restitution", "e of the impact element"}, n.restitution, si, {0, 1, true});
}

ImpactLaw pair_law(const char *name, const char *description) {
  return {.name = name,
          .description = description,
          .parameters = {"k_i", "e"},
          .exponents = {},
          .at = radial_rate,
          .of_mass = true,
          .needs = {"k_i_kN_per_m", "restitution"},
          .prepare = set_damping,
          .numbers = spring_and_dashpot,
          .opensees = dashpot_behind_a_gap,
          .csi = CsiLink::linear};
}

} // namespace

const LawFamily &kelvin_voigt_laws() {
  static const LawFamily family = [] {
    ImpactLaw bilateral =
        pair_law("signed", "k d + c d' with the radial rate until the penetration ends; returns e exactly");
    ImpactLaw no_tension = pair_law("no-tension", "max(0, k d + c d'): never pulls; rebound 0.675 for e = 0.65");
    no_tension.unilateral = true;
    ImpactLaw printed = pair_law("printed", "(2-21) as printed, k d + c |v|: rebound 1.000 for every e");
    printed.at = planar_speed, printed.opensees = nullptr, printed.csi = CsiLink::none;
    return LawFamily{.laws = {bilateral, no_tension, printed},
                     .parameters = {{"k_i", "kN/m", "k_i_kN_per_m", 1e3, 5e3, 5e7, true, &LawNumbers::k_i},
                                    {"e", "-", "restitution", 1, 0.01, 1.0, false, &LawNumbers::restitution}},
                     .visit = visit_pair};
  }();
  return family;
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

double kelvin_voigt_peak(double restitution) {
  const double xi = damping_ratio(restitution);
  if (xi >= 0.5) return 2 * xi; // the force is largest at touch
  const double root = std::sqrt(1 - xi * xi);
  const double angle = std::atan2(root * (1 - 4 * xi * xi), xi * (3 - 4 * xi * xi));
  return std::exp(-xi / root * angle);
}

} // namespace rimpact::laws

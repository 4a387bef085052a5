#include "laws/impact/bilinear.h"

#include "laws/impact/impact_law.h"

namespace rimpact::laws {
namespace {

ImpactForce bilinear_loading(const RimElement &r, double d) {
  const double yield = r.yield_force / r.stiffness, tangent = r.hardening * r.stiffness;
  if (d <= yield) return {r.stiffness * d, r.stiffness, 0};
  return {r.yield_force + tangent * (d - yield), tangent, 0};
}

ImpactForce bilinear_force(const RimElement &r, const RimMotion &m) {
  if (m.d >= m.deepest && m.d > 0) return bilinear_loading(r, m.d);
  return {bilinear_loading(r, m.deepest).force - r.stiffness * (m.deepest - m.d), r.stiffness, 0};
}

std::vector<std::pair<std::string, double>> bilinear_numbers(const RimElement &r) {
  return {{"stiffness_N_per_m", r.stiffness}, {"yield_force_N", r.yield_force}, {"hardening", r.hardening}};
}

OpenSeesMaterial bilinear_springs(const RimElement &) {
  return {.material = RimMaterial::gap_springs,
          .notes = {"Rim: bilinear gap springs in parallel, tuned to the law, which is one such spring.",
                    how_gap_springs_stand}};
}

} // namespace

ImpactLaw bilinear_law() {
  return {.name = "bilinear",
          .description = "the plainest yielding rim: two straight lines, back along the first; dents that stay",
          .parameters = {"k_i", "yield_force", "hardening"},
          .exponents = {},
          .at = bilinear_force,
          .unilateral = true,
          .yields = true,
          .needs = {"k_i_kN_per_m", "yield_force_kN", "hardening"},
          .numbers = bilinear_numbers,
          .opensees = bilinear_springs,
          .csi = CsiLink::plastic};
}

} // namespace rimpact::laws

#include "laws/impact/elastoplastic.h"

#include "laws/impact/bilinear.h"
#include "laws/impact/catalogue.h"
#include <algorithm>
#include <cmath>

namespace rimpact::laws {
namespace {

// Below the end of unloading the force by which the law is from pressing.
ImpactForce elastoplastic_force(const RimElement &r, const RimMotion &m) {
  if (!(m.deepest > 0) && m.d < 0) return {r.stiffness * m.d, r.stiffness, 0};
  if (m.d >= m.deepest) return elastoplastic_backbone(r, m.d);
  const Unloading back = unloading(r, m.deepest);
  const double s = 1 - (m.deepest - m.d) / back.length, bend = back.curvature * std::max(0.0, s),
               slope = back.top / back.length;
  return {back.top * s * (1 - back.curvature + bend), slope * (1 - back.curvature + 2 * bend), 0};
}

std::vector<std::pair<std::string, double>> elastoplastic_numbers(const RimElement &r) {
  return {{"stiffness_N_per_m", r.stiffness},   {"yield_force_N", r.yield_force},
          {"hardening", r.hardening},           {"hardening_exponent", r.hardening_exponent},
          {"unloading_gain", r.unloading_gain}, {"unloading_exponent", r.unloading_exponent}};
}

OpenSeesMaterial gap_springs(const RimElement &) {
  return {.material = RimMaterial::gap_springs,
          .notes = {"Rim: four bilinear gap springs in parallel, tuned to the law over the speeds of the self-check. "
                    "They unload in straight lines where the law's unloading bends.",
                    how_gap_springs_stand}};
}

void visit_elastoplastic(KeyVisitor &v, LawNumbers &n, const ImpactLaw &law) {
  v.number({"yield_force_kN", "F_y"}, n.yield_force, kilo, {0, huge, true});
  v.number({"hardening", "h: tangent over k_i just beyond yield"}, n.hardening, si, {0, 1});
  if (v.wants(law.reads("unloading_gain"))) {
    v.number({"hardening_exponent", "p: the tangent falls as (1 + k_i d / F_y)^(p - 1)"}, n.hardening_exponent, si,
             {0, 1, true});
    v.number({"unloading_gain", "a: unloading begins at k_i (1 + a (k_i d / F_y)^m)"}, n.unloading_gain, si, {0, 100});
    v.number({"unloading_exponent", "m"}, n.unloading_exponent, si, {0, 10, true});
  }
  v.number({"dent_spread", "a dent's flank radius over that of two circles"}, n.dent_spread, si, {0, 1e6, true});
}

} // namespace

const LawFamily &elastoplastic_laws() {
  static const LawFamily family{
      .laws = {{.name = "elastoplastic",
                .description = "yielding rim: softening load path, stiffer unloading, dents that stay",
                .parameters = {"k_i", "yield_force", "hardening", "unloading_gain"},
                .exponents = {"hardening_exponent", "unloading_exponent"},
                .at = elastoplastic_force,
                .unilateral = true,
                .yields = true,
                .needs = {"k_i_kN_per_m", "yield_force_kN", "hardening"},
                .numbers = elastoplastic_numbers,
                .opensees = gap_springs,
                .csi = CsiLink::plastic},
               bilinear_law()},
      .parameters = {{"yield_force", "kN", "yield_force_kN", 1e3, 10, 1e5, true, &LawNumbers::yield_force},
                     {"hardening", "-", "hardening", 1, 1e-3, 1.0, true, &LawNumbers::hardening},
                     {"unloading_gain", "-", "unloading_gain", 1, 0.0, 20.0, false, &LawNumbers::unloading_gain},
                     {"hardening_exponent", "-", "hardening_exponent", 1, 0.1, 1.0, false,
                      &LawNumbers::hardening_exponent},
                     {"unloading_exponent", "-", "unloading_exponent", 1, 0.25, 4.0, true,
                      &LawNumbers::unloading_exponent},
                     {"dent_spread", "-", "dent_spread", 1, 0.5, 100.0, true, &LawNumbers::dent_spread}},
      .visit = visit_elastoplastic};
  return family;
}

ImpactForce elastoplastic_backbone(const RimElement &r, double d) {
  const double p = r.hardening_exponent, h = r.hardening, x = r.stiffness * d / r.yield_force, knee = (1 - h) * x,
               root = std::sqrt(1 + knee * knee);
  return {r.yield_force * (knee / root + h / p * std::expm1(p * std::log1p(x))),
          r.stiffness * ((1 - h) / (root * root * root) + h * std::pow(1 + x, p - 1)), 0};
}

Unloading unloading(const RimElement &r, double deepest) {
  const double top = elastoplastic_backbone(r, deepest).force,
               slope = r.stiffness *
                       (1 + r.unloading_gain * std::pow(r.stiffness * deepest / r.yield_force, r.unloading_exponent)),
               w = std::min(opening, slope * deepest / top - 1);
  return {top, w, (1 + w) * top / slope};
}

} // namespace rimpact::laws

#include "laws/impact/pushed_curve.h"

#include "laws/impact/catalogue.h"

namespace rimpact::laws {
namespace {

// Along the loading to the deepest penetration, from and to it along the unloading.
ImpactForce curve_force(const RimElement &r, const RimMotion &m) {
  const RimCurve::Force f =
      m.deepest > 0 && m.d < m.deepest ? r.curve->unloading(m.d, m.deepest) : r.curve->loading(m.d);
  return {f.force, f.slope, 0};
}

void visit_curve(KeyVisitor &v, LawNumbers &n, const ImpactLaw &) {
  v.text({"impact_curve", "curve.h5 of this bearing, made by rimpact curve"}, n.impact_curve);
}

} // namespace

const LawFamily &pushed_curve_laws() {
  static const LawFamily family{
      .laws = {{.name = "curve",
                .description = "the bearing's own rim, pushed once by finite elements (rimpact curve)",
                .parameters = {},
                .exponents = {},
                .at = curve_force,
                .unilateral = true,
                .yields = true,
                .pushed = true,
                .needs = {}}},
      .parameters = {},
      .visit = visit_curve};
  return family;
}

RimElement curve_element(std::shared_ptr<const RimCurve> curve) {
  RimElement rim;
  rim.stiffness = curve->loading(0).slope;
  rim.curve = std::move(curve);
  rim.law = &pushed_curve_laws().laws.front();
  return rim;
}

} // namespace rimpact::laws

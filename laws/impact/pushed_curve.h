/// The bearing's own rim, as pushed once by finite elements (`rimpact curve`).
#pragma once
#include "laws/impact/rim_curve.h"
#include <memory>
#include <string>

namespace rimpact::laws {

struct CurveNumbers {
  std::string impact_curve = {}; ///< file of the law curve, as `rimpact curve` writes it
  bool operator==(const CurveNumbers &) const = default;
};

struct RimElement;
/// The element of the law curve; its stiffness is the loading's first slope.
RimElement curve_element(std::shared_ptr<const RimCurve> curve);

} // namespace rimpact::laws

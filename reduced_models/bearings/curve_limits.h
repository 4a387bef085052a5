/// What a quasi-static curve of the rim (rim_curve.h) says nothing of.
#pragma once
#include "reduced_models/bearings/dented_rim.h"
#include <optional>

namespace rimpact::reduced {

/// Of a slide along the wall, and of a second hit's distance from a dent, over half the touch's length: what a straight
/// push stands for.
inline constexpr double curve_slide = 0.05;

/// A slider on the rim.
struct PressedRim {
  double d;      ///< penetration [m]
  double rate;   ///< d' [m/s], > 0 outwards
  double mass;   ///< supported [kg]
  bool airborne; ///< it has lifted off the dish
};
/// Why the curve holds no longer, a sentence with value and bound: too deep, too fast for its work, lifted off, slid
/// along the wall, or beside a dent. None: it holds. `u`: the slider's displacement.
std::optional<std::string> beyond_curve(const laws::RimCurve &curve, const PressedRim &press, const DentedRim &rim,
                                        const Eigen::Vector2d &u, const DentShape &shape);

} // namespace rimpact::reduced

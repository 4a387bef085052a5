/// Unilateral normal contact by augmented Lagrangian, at one point. Signs: gap > 0 open; pressure >= 0,
/// pushing.
///   p = max(0, lambda - epsilon g)            (Alart and Curnier 1991; Wriggers, Computational Contact
///   Mechanics)
/// The multiplier lambda is the pressure of the last augmentation, so the penetration left is (p -
/// lambda)/epsilon. Above `ceiling`, a pressure no solution reaches, the slope drops: a Newton iterate that
/// overlaps by far then pushes firmly instead of turning cells inside out. The law stays monotone and
/// continuous.
#pragma once
#include <limits>

namespace rimpact::fe {

struct NormalContact {
  double penalty;                                           ///< epsilon [Pa/m], > 0
  double ceiling = std::numeric_limits<double>::infinity(); ///< [Pa]; see above
  static constexpr double slope_above = 0.02;               ///< of epsilon

  struct Result {
    double pressure; ///< [Pa]
    double slope;    ///< -dp/dg [Pa/m], >= 0
  };
  Result at(double gap, double multiplier) const {
    const double pressure = multiplier - penalty * gap;
    if (pressure <= 0) return {0.0, 0.0};
    if (pressure <= ceiling) return {pressure, penalty};
    return {ceiling + slope_above * (pressure - ceiling), slope_above * penalty};
  }
};

} // namespace rimpact::fe

/// Unilateral normal contact by augmented Lagrangian, at one point. Signs: gap > 0 open; pressure >= 0,
/// pushing.
///   p = max(0, lambda - epsilon g)            (Alart and Curnier 1991; Wriggers, Computational Contact
///   Mechanics)
/// The multiplier lambda is the pressure of the last augmentation, so the penetration left is (p -
/// lambda)/epsilon.
#pragma once
#include <algorithm>

namespace rimpact::fe {

struct NormalContact {
  double penalty; ///< epsilon [Pa/m], > 0

  struct Result {
    double pressure; ///< [Pa]
    double slope;    ///< -dp/dg [Pa/m], >= 0
  };
  Result at(double gap, double multiplier) const {
    const double pressure = multiplier - penalty * gap;
    return pressure > 0 ? Result{pressure, penalty} : Result{0.0, 0.0};
  }
};

} // namespace rimpact::fe

/// What a frictional contact says of one evaluation.
#pragma once
#include <Eigen/Core>
#include <limits>

namespace rimpact::fe {

struct SurfaceContactReport {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();               ///< on the body [N]
  Eigen::Vector3d friction = Eigen::Vector3d::Zero();            ///< its tangential tractions' part [N]
  double smallest_gap = std::numeric_limits<double>::infinity(); ///< [m]
  double penetration = 0;                                        ///< largest, pointwise [m]
  double largest_pressure = 0;                                   ///< [Pa]
  int stick = 0, slip = 0;                                       ///< points
  int lost = 0; ///< points opposite the master at the step's start and still on its surface for which no face is found:
                ///< what they bear is missing
  double normal_work = 0, friction_work = 0;   ///< taken up since the step's start, trapezoidal [J]
  bool pattern_holds = true;                   ///< false: a pair of faces is not in the matrix's pattern
  void add(const SurfaceContactReport &other); ///< of other points, all but the works
  void all_reduce();                           ///< over the ranks, all but the works
};

} // namespace rimpact::fe

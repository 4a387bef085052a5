/// How much moment an end section of reinforced concrete bears beside its axial force, in closed form:
///   M(P) = M_0 + P h / 2 (1 - P / P_0),   0 <= P <= P_0,      P compression,
/// the stress block 0.85 f_c over a part of the depth h, with two equal layers of steel that yield, one pulled and one
/// pressed: M_0 = A_s f_y z / 2. In tension steel alone bears, M_0 (1 - N / T_0), T_0 = A_s f_y = 2 M_0 / z; beyond P_0
/// a line to P_0 + T_0, where all is crushed. z = 0.8 h is an assumption. Source: any text on reinforced concrete, e.g.
/// Park and Paulay, Reinforced concrete structures (1975), chapter 5; derived anew. SI units.
#pragma once

namespace rimpact::buildings {

struct AxialBending {
  double crush; ///< P_0 [N], > 0
  double plain; ///< M_0 [N m], > 0
  double depth; ///< h, in the plane of bending [m], > 0

  static constexpr double lever = 0.8;                        ///< z over h [-]
  double pull() const { return 2 * plain / (lever * depth); } ///< T_0 [N]
  struct Factor {
    double value; ///< M over M_0, never below `least` [-]
    double slope; ///< its derivative by the axial force [1/N]
  };
  static constexpr double least = 0.05;
  Factor factor(double axial) const; ///< axial: tension above 0 [N]
  double largest() const;            ///< of the factor: at P_0 / 2 [-]
};

} // namespace rimpact::buildings

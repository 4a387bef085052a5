/// Preliminary design of a friction-pendulum isolation system by the equivalent lateral force procedure (ASCE/SEI
/// 7-16, 17.5): what an engineer has before any response history. SI units; friction, damping and shears over weight
/// are pure numbers.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace rimpact::reduced {

struct IsolationDesignInput {
  double radius = 2.25;               ///< R of the pendulum [m], > 0
  double friction = 0.07;             ///< mu, >= 0 and < 1
  std::optional<double> displacement; ///< D [m], > 0; empty: found from `spectral_acceleration`
  std::optional<double>
      spectral_acceleration; ///< S_M1 = F_v S_1 [g], > 0: of the maximum considered earthquake, 5 % damping, 1 s
  double mass_ratio = 1;     ///< gamma = m_s / (m_s + m_b), in (0, 1]
  std::optional<double> superstructure_period; ///< T_s [s], > 0, of the fixed-base structure
  double reduction = 1;                        ///< R_I, >= 1
  double gravity = 9.81;                       ///< [m/s^2]
};

struct IsolationDesign {
  double displacement = 0;                  ///< D_M [m]
  double total_displacement = 0;            ///< D_TM = 1.15 D_M [m], the least allowance for accidental torsion
  double effective_period = 0;              ///< T_eff = 2 pi sqrt(D / (g (D/R + mu))) [s]
  double damping = 0;                       ///< beta = 2 mu / (pi (D/R + mu)), of critical, in [0, 2/pi]
  double base_shear = 0;                    ///< V_b / W = D/R + mu
  double structure_shear = 0;               ///< V_st / W = (V_b / W) gamma^(1 - 2.5 beta)
  double design_shear = 0;                  ///< V_st / (W R_I)
  std::optional<double> yield_displacement; ///< u_y = V_st / (R_I (2 pi / T_s)^2 (m_s + m_b)) [m]
  std::vector<std::string> remarks;         ///< limits of the procedure that this design meets, one sentence each
};

/// Damping coefficient B_M of table 17.5-1, linear between its rows; 2.0 beyond a damping of 0.5.
double damping_coefficient_of(double damping);
/// Throws InputError naming the value and its bound; also where the spectrum leaves no displacement (friction holds).
IsolationDesign design_isolation(const IsolationDesignInput &input);

} // namespace rimpact::reduced

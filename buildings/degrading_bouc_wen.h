/// Hysteretic law of Bouc and Wen that loses strength and stiffness with the energy it has taken, in one direction:
///   F = r k d + (1 - r) F_y z,      k = F_y / d_y,
///   eta d_y z' = d' (1 - nu |z|^n (beta sign(z d') + 1 - beta)),
///   nu = 1 + d_nu e,  eta = 1 + d_eta e,      e' = nu |z|^n (beta |z d'| + (1 - beta) z d') / d_y.
/// Where the capacity g moves with something else (an axial force), |z / g|^n stands for |z|^n, nu times it at most 1,
/// and the yield force becomes g F_y. z stays as g moves, which does no work; a |z| beyond g comes down to it by the
/// time constant `relaxation`, and what was stored above is lost. Source: Baber and Wen, J. Eng. Mech. Div. 107 (1981);
/// without degradation thesis (2-26), (2-27), d' / d_y where (2-27) prints u_y d'. There e is the work of z, which
/// unloading takes back in part; here it is what the loop has lost for good, so that nothing heals. Over closed loops
/// both agree. At n = 2 and beta = 1/2 loading from rest without degradation is z = tanh(d / d_y).
#pragma once
#include <optional>

namespace rimpact::buildings {

struct DegradingBoucWen {
  double yield_force = 1;       ///< F_y, > 0; its unit is that of F
  double yield_deformation = 1; ///< d_y, > 0; its unit is that of d
  double post_yield = 0.02;     ///< r [-], 0..1; 1 is elastic
  double exponent = 2;          ///< n [-], >= 1
  double beta = 0.5;            ///< [-], 0.5..1
  double strength_loss = 0;     ///< d_nu [-], 0..1
  double stiffness_loss = 0;    ///< d_eta [-], 0..2: above, a loop could give energy
  struct Capacity {
    double value = 1; ///< g [-], > 0
    double dt = 0;    ///< of the stage's own rate [s]; 0: z stays beyond g
  };
  static constexpr double relaxation = 1e-3; ///< [s], assumption
  std::optional<Capacity> capacity = {};     ///< none: it does not move, 1
  double stiffness() const { return yield_force / yield_deformation; }

  /// A deformation with its hysteretic state and normalised lost energy, or their rates.
  struct Point {
    double d = 0, z = 0, e = 0;
  };
  Point rates(const Point &at, double d_rate) const;
  double force(const Point &at) const;

  struct Step {
    Point at;
    double force, slope; ///< F and dF/dd of the stage
  };
  /// Stage z = z0 + w z'(z, e, d'), e alike, with w d' = d - d0: `base` holds d0, z0, e0. Newton, kept within bounds
  /// that hold the solution, starts at `guess`.
  Step implicit_step(const Point &base, double d, const Point &guess) const;

  /// Of the unit of F d: held by the springs, and the rate of loss, never negative. `at_rates` as `rates` has them.
  double stored(const Point &at) const;
  double loss(const Point &at, const Point &at_rates) const;
  double strength_left(const Point &at) const;  ///< of z's own bound, nu^(-1/n) [-]
  double stiffness_left(const Point &at) const; ///< 1 / eta [-]
};

} // namespace rimpact::buildings

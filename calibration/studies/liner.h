/// A sacrificial liner on the rim's wall that crushes at one stress: how thick it must be, and how hard, for a mass to
/// be stopped at no more than a force.
///
/// In plan the liner is a ring on the wall, of inner radius R, and the slider a disc of radius r < R that goes into it
/// by d, its centre at x = R - r + d. What is crushed is the part A(d) of the disc outside the ring's inner circle, and
/// the chord w(d) that the two circles share is what resists:
///   W(d) = sigma b A(d),  F(d) = sigma b w(d) = dW/dd,  w = 2 R sin(beta),  cos(beta) = (x^2 + R^2 - r^2) / (2 x R)
/// with b the height of the slider's side that faces the wall. The force rises up to the stroke D that takes the
/// energy:
///   A(D) / w(D) = E / F_max,  sigma = F_max / (b w(D)),  thickness = D / eta,
/// about E = 2/3 F_max D while D is small, and F_max D were the chord constant. D holds for any b and sigma.
/// Assumed: the stress is one number until a share eta of the thickness is crushed, at any speed; nothing springs back;
/// the liner takes all of the energy, the rim none; slider and wall keep their shapes. SI units.
#pragma once

namespace rimpact::calibration {

struct LinerCase {
  double energy = 0;        ///< to take, m v^2 / 2 [J], > 0
  double most_force = 0;    ///< [N], > 0
  double slider_radius = 0; ///< [m], > 0, < wall_radius
  double wall_radius = 0;   ///< the bare wall's [m]
  double crush_share = 0;   ///< eta, in (0, 1]
};
struct Liner {
  double thickness = 0; ///< [m]
  double stroke = 0;    ///< D [m]
  double chord = 0;     ///< w(D) [m]
  /// sigma [Pa] for a height b > 0 [m] of the slider's side before the wall.
  double crush_stress(double most_force, double band) const { return most_force / (band * chord); }
};

/// w [m] of a disc that has gone `depth` into a ring of inner radius `ring`.
double liner_chord(double ring, double slider, double depth);
/// A [m^2]: of the disc, outside the ring's inner circle.
double liner_area(double ring, double slider, double depth);
/// Greatest depth up to which the chord grows: there it is the slider's diameter.
double liner_deepest(double ring, double slider);

/// Throws InputError naming the value and its bound where a number is out of its range, and where no liner does it: it
/// would be thicker than the travel, or the whole slider would go into it.
Liner liner_for(const LinerCase &wanted);

} // namespace rimpact::calibration

/// The ellipsoid of revolution that an exported slider rides on, and the friction that goes with it.
///
/// OpenSees has elements that slide in a plane, and trusses that keep a length. A truss of length a from a node on the
/// bearing's axis keeps its other end on a sphere of radius a. A lever divides that end's height by a / b. What hangs
/// on the lever then rides on the ellipsoid of half-widths a and b: its height is b - b sqrt(1 - (r / a)^2), exactly.
/// A sphere has b = a and needs no lever. So the slider rises as it travels, the normal force N follows its vertical
/// motion, and so do restoring force and friction. A flat slider has N = W there: shfps-225 then meets its rim at
/// 0.30 m/s in the place of 0.16.
///
/// Two things are said of the horizontal push Q per vertical reaction N_v of a mass on a slope h' whose friction f acts
/// along the slope: Q = (h' + f S^2 / (1 - f h')) with S^2 = 1 + h'^2, the travel being outwards. To first order in
/// f h' this is h' + f S^2 + f^2 S^2 h'. The last term restores, whatever the direction; it stands in the table of what
/// the ellipsoid leaves. f S^2 grows with travel, and so does the socket's share of f. It is taken as c0 + c1 p, with p
/// the ellipsoid's slope: c0 is the sliding element's coefficient, and c1 W a friction that opposes the rise.
#pragma once
#include <functional>
#include <vector>

namespace rimpact::calibration {

struct Rider {
  double half_width = 1;            ///< a [m]
  double ratio = 1;                 ///< b / a [-], 0..1; 1: a sphere
  double slope(double r) const;     ///< p [-]; odd in r, |r| < a
  double curvature(double r) const; ///< dp/dr [1/m]
};
/// Least squares of its slope over h' at these travels [m], growing from zero; past the last the ellipsoid still is.
Rider rider_of(const std::vector<double> &travel, const std::vector<double> &slope);

/// Coefficients over travel as the exported bearing has them: `slides` times N, and `rises` times W times p.
struct RidingFriction {
  double slides = 0; ///< c0 [-], >= 0
  double rises = 0;  ///< c1 [-], >= 0
};
/// Of `per_reaction`, f S^2 at travel r: least squares from the centre to `capacity`.
RidingFriction riding_friction(const Rider &rider, double capacity,
                               const std::function<double(double r)> &per_reaction);
/// Mean of `function` from 0 to `capacity`.
double mean_to(double capacity, const std::function<double(double r)> &function);

} // namespace rimpact::calibration

/// Laws of the rim element: force of the rim on the slider over penetration d and its rate (thesis eq. 2-19
/// to 2-22, and laws for a rim that yields). Pure values; one function and one catalogue line a law. SI
/// units, force > 0 pushes the slider inwards.
#pragma once
#include "reduced_models/rim_curve.h"
#include "scene/scene.h"
#include <string>
#include <vector>

namespace rimpact::reduced {

/// Force and its partial derivatives; `d_speed` is zero except for laws that count the planar speed.
struct ImpactForce {
  double force;         ///< [N]
  double d_penetration; ///< [N/m]
  double d_rate;        ///< [N s/m]
  double d_speed = 0;   ///< [N s/m]
};

/// What a law sees of the contact.
struct RimMotion {
  double d;           ///< penetration [m], >= 0
  double rate;        ///< d' [m/s], > 0 while approaching
  double speed = 0;   ///< planar [m/s], >= |rate|
  double deepest = 0; ///< penetration this arc of the rim had reached before [m]; read by laws that yield
};

struct RimElement;

struct ImpactLaw {
  std::string name, description;
  std::vector<std::string> parameters; ///< of the element that the law reads, named as calibrations do
  std::vector<std::string> exponents;  ///< of its curves' shape: fitted last, where impacts are many enough
  ImpactForce (*at)(const RimElement &rim, const RimMotion &motion);
  /// True: never pulls. The element lets go when `at` falls to zero and presses again when it rises through
  /// zero with d > 0. False: it lets go when the penetration ends.
  bool unilateral;
  bool yields;                                    ///< reads `deepest`: the rim remembers its dents
  bool reads(const std::string &parameter) const; ///< exponents too
};
const std::vector<ImpactLaw> &impact_laws();
/// Throws InputError naming the known laws.
const ImpactLaw &impact_law(const std::string &name);

/// The element of one rim.
struct RimElement {
  double stiffness = 0;             ///< k_i [N/m]; 0: no element
  double damping = 0;               ///< c_i [N s/m] (signed, no-tension, printed)
  double exponent = 1.5;            ///< of the penetration [-] (hunt-crossley), > 0
  double dissipation = 0;           ///< chi [s/m] (hunt-crossley), >= 0
  double yield_force = 1;           ///< F_y [N] (elastoplastic), > 0
  double hardening = 0;             ///< h [-] (elastoplastic), 0..1: tangent h k_i (1 + x)^(p - 1) beyond yield
  double hardening_exponent = 0.75; ///< p [-] (elastoplastic), 0..1
  double unloading_gain = 0;        ///< a [-] (elastoplastic), >= 0
  double unloading_exponent = 0.5;  ///< m [-] (elastoplastic), > 0
  const ImpactLaw *law = nullptr;   ///< into impact_laws()
  std::shared_ptr<const RimCurve> curve = nullptr; ///< read by the law curve, which needs one
  ImpactForce at(const RimMotion &motion) const;
  /// The law's force before a unilateral element lets go [N]: its sign decides whether it presses.
  double trial(const RimMotion &motion) const { return law->at(*this, motion).force; }
};
/// Of a law given by numbers. Throws InputError for e outside (0, 1], an unknown law, or the law curve, which belongs
/// to a bearing.
RimElement rim_element(const scene::ReducedSettings &settings, double mass);
/// The element of the law curve; its stiffness is the loading's first slope.
RimElement curve_element(std::shared_ptr<const RimCurve> curve);

/// xi of (2-20): -ln e / sqrt(pi^2 + ln^2 e) [-], 0 < e <= 1.
double damping_ratio(double restitution);
/// c_i of (2-20) with m1 = supported mass and m2 -> infinity (rim fixed): 2 xi sqrt(k m) [N s/m].
double damping_coefficient(double stiffness, double restitution, double mass);

/// chi [s/m] of F = K d^n (1 + chi d') that gives restitution e at the approach speed v: with a = chi v,
/// a - ln(1 + a) = -e a - ln(1 - e a), whatever K, n and the mass (work of both phases over the same d).
double hunt_crossley_dissipation(double restitution, double speed);
/// Penetration at which k_i of `hunt-crossley` is the secant stiffness [m].
inline constexpr double hunt_crossley_penetration = 1e-3;

/// First loading of `elastoplastic`, F_y [c x / sqrt(1 + (c x)^2) + h ((1 + x)^p - 1) / p], and its slope;
ImpactForce elastoplastic_backbone(const RimElement &rim, double d); ///< x = k_i d / F_y, c = 1 - h
/// From the deepest penetration D and its force F back: F [(1 - w) s + w s^2], s = 1 - (D - d) / length, as a touch
/// that opens does. The slope at the top, (1 + w) F / length, is k (1 + a (k D / F_y)^m): a deeper dent is wider and so
/// stiffer. w = opening, less where the curve would reach past d = 0.
struct Unloading {
  double top;                                                                        ///< F [N]
  double curvature;                                                                  ///< w [-], 0..1
  double length;                                                                     ///< [m], <= D
  double elastic_energy() const { return top * length * (1.0 / 2 - curvature / 6); } ///< [J]
};
/// As s^1.4 (within 1.6 % of F), to which the reference curves of rungs rim and rigid-dish open from 0.1 to 0.7 m/s
/// (docs/decisions/0009-how-a-rim-returns.md), but smooth at its end.
inline constexpr double opening = 0.5;
Unloading unloading(const RimElement &rim, double deepest); ///< D [m], > 0
/// Indentation left after unloading from `deepest` [m].
double residual_indentation(const RimElement &rim, double deepest);

/// F_peak / (v sqrt(k m)) of a free mass on a linear Kelvin-Voigt rim of restitution e (law `signed`):
/// exp(-xi t*), 0.853 at e = 0.65. e in (0, 1].
double kelvin_voigt_peak(double restitution);

} // namespace rimpact::reduced

/// A rim that yields: along a softening backbone to the deepest penetration, from and to it along a stiffer curve of
/// unloading. Rate-independent, so that it belongs to the rim and not to the mass; dents stay.
#pragma once

namespace rimpact::laws {

struct ImpactForce;
struct RimElement;

struct ElastoplasticNumbers {
  double yield_force = 0.8e6; ///< F_y [N], > 0
  double hardening = 0.08;    ///< h [-], 0..1: tangent h k_i (1 + x)^(p - 1) beyond yield
  double hardening_exponent =
      0.75;                        ///< p [-], 0..1: a dent spreads as it deepens, so the rim hardens less than linearly
  double unloading_gain = 0.3;     ///< a [-], >= 0: unloading begins at k_i (1 + a (k_i d / F_y)^m)
  double unloading_exponent = 0.5; ///< m [-], > 0
  double dent_spread = 3.0;        ///< flank radius of a dent over that of slider and wall as circles [-], > 0
  bool operator==(const ElastoplasticNumbers &) const = default;
};

/// First loading, F_y [c x / sqrt(1 + (c x)^2) + h ((1 + x)^p - 1) / p], and its slope; x = k_i d / F_y, c = 1 - h.
/// The knee is that of Menegotto and Pinto (1973) with exponent 2.
ImpactForce elastoplastic_backbone(const RimElement &rim, double d);

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

} // namespace rimpact::laws

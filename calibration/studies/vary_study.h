/// The designer's question: what one isolated impact does to rims of which dimensions or steel are varied. Each rim is
/// pushed once (`rimpact curve --held`), and a mass at a speed is stopped by its curve's work:
///   int_0^D F dd = m v^2 / 2,  rebound = sqrt(2 W_returned(D) / m).
/// Between the rims that were pushed, values are interpolated by a parabola in the logarithms.
#pragma once
#include "reduced_models/bearings/rim_curve_file.h"
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rimpact::calibration {

/// How far a curve is from impacts of rung rim at most, over 18 windows of three rims from 0.05 to 0.7 m/s: the largest
/// magnitudes in tests/verification/rim_curve.txt, which a test reads. Relative.
struct CurveAgainstWindows {
  double force = 0.0198, restitution = 0.0149;
};

struct VariedKey {
  std::string key;            ///< of a bearing, "rim.thickness_mm"
  std::vector<double> values; ///< rising, in the key's unit
};
struct VaryQuestion {
  std::vector<VariedKey> keys;
  double speed = 0;                      ///< of approach [m/s], > 0
  double mass = 0;                       ///< supported [kg], > 0
  double weight = 0;                     ///< dead load [N]
  std::optional<double> strain_limit;    ///< of the steel [-]; none: not judged
  std::map<std::string, double> targets; ///< most of peak_kN, depth_mm, rebound_m_per_s, strain, rim_foot_use
};
/// "rim.thickness_mm = 40", of several keys with commas.
std::string in_words(const std::vector<double> &at, const VaryQuestion &question);
/// What can be a target, in the order of a row's columns.
const std::vector<std::string> &vary_outputs();

/// A rim at every speed and mass: over the impact's severity v sqrt(m), rising from 0 in equal steps.
struct SeverityTable {
  std::vector<double> severity;          ///< [m/s sqrt(kg)]
  std::vector<double> peak_force, depth; ///< [N], [m]
  std::vector<double> rebound;           ///< of the rebound speed, times sqrt(m) [m/s sqrt(kg)]
  std::vector<double> strain;            ///< averaged [-]; empty: the curve does not say
  std::vector<double> foot_use;          ///< [-]; empty: one piece with the plate
};

/// One rim at the question's speed.
struct VaryPoint {
  std::string name;
  std::vector<double> at;               ///< the keys' values
  double peak_force, depth, rebound;    ///< [N], [m], [m/s]
  std::optional<double> strain;         ///< of the rim's side, averaged [-]; none: the curve does not say
  std::optional<double> foot_use;       ///< of the joint at the rim's foot [-]; none: one piece with the plate
  std::optional<double> foot_goes_at;   ///< speed at which its use passes 1 [m/s]; none: not up to `fastest`
  std::optional<double> speed_at_limit; ///< at which the strain passes its limit [m/s]; none: not up to `fastest`
  double fastest;                       ///< that the curve stops [m/s]
  SeverityTable table = {};             ///< up to `fastest`; empty between the rims
  double output(std::size_t k) const;   ///< in vary_outputs()'s order and units; NaN where it is not known
};
/// Throws DataError where the curve does not stop the question's speed.
VaryPoint vary_point(const reduced::RimCurveFile &curve, const VaryQuestion &question);

struct Interpolated {
  double value;
  std::optional<double> error; ///< relative: the parabola against the straight line between neighbours, 0 at a point;
                               ///< none: two points say nothing of it
};
/// Of output `k` over the first key; `points` rise in it.
Interpolated interpolated(const std::vector<VaryPoint> &points, std::size_t k, double x);

} // namespace rimpact::calibration

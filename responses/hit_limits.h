/// Impacts of a run by where its models are known to hold.
#pragma once
#include "responses/summary.h"

namespace rimpact {

/// Approach speeds an element is known for [m/s]; none: open on that side.
struct SpeedRange {
  std::optional<double> from, to;
  bool is_known() const { return from || to; }
  bool holds(double speed) const; ///< a bound is met to a thousandth: a window's speed is met to rounding
};

/// Supported by a bearing, the heaviest loaded of a building [kg].
double carried_mass(const scene::Scene &scene, const Summary &summary);
/// reduced.fitted_from_m_per_s and _to_ at this supported mass [kg].
SpeedRange fitted_speeds(const scene::Scene &scene, double mass);

/// Columns of a fleet's table, each a number, or null where it is not known. Counts of impacts: outside the fitted
/// speeds (hits_beyond_fit), faster than the published pair is known for (hits_beyond_pair), deeper than the rim is
/// thick (hits_beyond_rim). Beside them those that strain
/// the rim's steel beyond its limit (hits_beyond_steel): finite elements tell the largest strain. Reduced models know
/// it by the penetrations of the calibration's runs (steel_by_depth.h). Then the slowest and fastest approach, and the
/// speeds the element is known for.
nlohmann::json hit_limits(const scene::Scene &scene, const Summary &summary);

} // namespace rimpact

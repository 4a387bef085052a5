/// How far a candidate response is from a reference: the five figures of docs/interface.md (`compare`,
/// `calibration.json`) and what goes with them. Signed relative errors are (candidate - reference) /
/// reference.
#pragma once
#include "responses/response.h"
#include <nlohmann/json.hpp>
#include <optional>

namespace rimpact::calibration {

/// A figure is empty when it has no meaning (no impact, say); `notes` then holds the reason.
struct Comparison {
  std::optional<double> peak_force_error;        ///< of the peak impact force (horizontal norm) [-]
  std::optional<double> peak_displacement_error; ///< of the peak horizontal displacement [-]
  std::optional<double> approach_speed_error;    ///< of the radial speed at the touch of the hardest impact [-]
  std::optional<double> rebound_error;           ///< of the radial speed at release of the hardest impact, where both
                                                 ///< records hold the release [-]
  std::optional<double> restitution_error;       ///< of rebound over approach; it holds the approaches' difference too
  std::optional<double> nrmse_displacement;      ///< root mean square of |u_c - u_r| over L_c [-]
  std::optional<double> nrmse_force;             ///< of |I_c - I_r| (impact force) over the reference's peak [-]
  std::optional<double> nrmse_lateral_force;     ///< of |F_c - F_r| (lateral force) over the reference's peak [-]
  std::optional<double> touch_time_difference;   ///< first touch, candidate - reference [s]
  std::vector<std::string> notes;
};

/// Both means run over time from the reference's first touch to 0.5 s after its last release, or to where the
/// shorter response ends. They are taken on the union of both time bases, linear between samples. A reference without
/// impact is compared over its whole length, and the figures that need an impact stay empty. Throws
/// InputError for lateral_capacity <= 0, DataError when the responses do not overlap in time.
Comparison compare(const Response &reference, const Response &candidate, double lateral_capacity);

nlohmann::json to_json(const Comparison &comparison);

} // namespace rimpact::calibration

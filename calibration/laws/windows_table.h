/// k_i and e over impact speed, from runs of one isolated impact each, and the range in which one pair
/// serves.
#pragma once
#include "calibration/fit/fit.h"

namespace rimpact::calibration {

struct WindowRow {
  std::string folder;
  double speed;                                                     ///< approach speed [m/s]
  double peak_force, contact_time, peak_penetration, rebound_speed; ///< of the reference, SI
  double normalised_force;                                          ///< F / (v sqrt(k m)) with the pair's k [-]
  double restitution;                                               ///< rebound / approach of the reference [-]
  FitResult own;                                                    ///< fit of this window alone
  /// straight from the curve, for a linear Kelvin-Voigt rim: k from the peak force and from the contact time
  /// [N/m]
  std::optional<double> k_from_peak, k_from_contact_time;
  double pair_force_error;   ///< of the constant pair in this window, signed relative
  double pair_rebound_error; ///< over the approach speed
  bool pair_holds;           ///< |pair_force_error| <= tolerance
};

struct WindowsTable {
  std::vector<WindowRow> rows; ///< by speed
  double tolerance = 0.10;     ///< on the peak force
  std::optional<double> valid_from,
      valid_to;         ///< largest run of neighbouring speeds at which the pair holds [m/s]
  std::string sentence; ///< for engineers
};

/// `pair` is the constant pair (its k_i, e are judged against every window).
WindowsTable windows_table(const std::vector<const StoredRun *> &windows, const FitResult &pair,
                           const FitOptions &options, double tolerance = 0.10);

} // namespace rimpact::calibration

/// What the rate of the steel does to single impacts: windows of steel without a rate beside windows of the same speeds
/// whose steel knows it. Static steel is on the unsafe side for the force, steel at speed for nothing but the travel:
/// two windows bound both.
#pragma once
#include "responses/summary.h"
#include "scene/material.h"
#include <optional>
#include <string>
#include <vector>

namespace rimpact::calibration {

/// One speed, both ways.
struct SteelTwin {
  double speed;                                               ///< approach [m/s], > 0
  Impact static_steel, fast;                                  ///< of steel without and with its rate
  std::optional<FootReport> static_foot = {}, fast_foot = {}; ///< of the rim's foot, alike; none: not known

  double force_ratio() const { return fast.peak_force / static_steel.peak_force; }
  double depth_ratio() const { return fast.peak_penetration / static_steel.peak_penetration; }
  double rebound_ratio() const { return fast.rebound_speed / static_steel.rebound_speed; }
};

struct SteelBand {
  scene::StrainRate rate;       ///< of the fast windows
  bool assumed = false;         ///< its constants are ours, not the file's
  bool runs_are_static = true;  ///< the runs fitted are of static steel, and the twins fast; else the other way round
  std::vector<SteelTwin> twins; ///< by growing speed, one at least
  std::string calibration;      ///< folder of the twins' own law, beside the answer's; empty: none was fitted

  /// Largest change over the twins, of a ratio to 1 [-].
  double largest(double (SteelTwin::*ratio)() const) const;
};

/// For page one, the terminal and exports, in short sentences.
std::vector<std::string> sentences(const SteelBand &band);

} // namespace rimpact::calibration

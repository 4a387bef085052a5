/// The lag of the force channel, found by momentum (channel_lag.h) and taken off.
#pragma once
#include "calibration/data/impact_window.h"

namespace rimpact::calibration {

struct ForceClock {
  double lag;    ///< of the force behind the displacement [s]
  double unsure; ///< standard error [s]
  int n_impacts; ///< that told it
  std::string sentence() const;
};

/// Shifts impact_x and impact_y of the run's response to the clock of its displacement, where its samples lie, and
/// leaves out the ends that are then without force. The lag is first that of the largest force behind the largest
/// travel, then corrected by each impact's channel_lag(), impacts weighted by their uncertainty, until nothing is left
/// within it. Throws DataError naming the run where no impact has the flights beside it that this takes.
ForceClock align_force(const std::string &folder, const scene::Scene &scene, Response &response,
                       const WindowOptions &options);

} // namespace rimpact::calibration

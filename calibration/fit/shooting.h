/// The reduced model in place of the reference within one impact window.
#pragma once
#include "calibration/data/impact_window.h"

namespace rimpact::calibration {

/// The reduced model's own samples: radial displacement [m] and velocity [m/s], pushing force [N].
struct Flight {
  std::vector<double> times, displacement, velocity, force;
  double rebound_speed = 0; ///< inward radial speed at the end of the first contact [m/s]
};
/// Starts from window.start and integrates to window.end_time, longer where the rim still presses then, with the
/// settings of `scene`.
Flight fly(const scene::Scene &scene, const ImpactWindow &window);

/// Radial quantities as in ImpactWindow, at its sample times.
struct Shot {
  std::vector<double> displacement, force;
  double peak = 0;          ///< smooth_peak() of the force [N]
  double rebound_speed = 0; ///< inward radial speed at the end of the first contact [m/s]
};

/// The same at the reference's samples.
Shot shoot(const scene::Scene &scene, const ImpactWindow &window);
/// The same from another state.
Shot shoot(const scene::Scene &scene, const ImpactWindow &window, const reduced::BearingState &start);

/// The whole run by the model. Of a measured window, which is recorded from before its touch, on the record's clock.
Response history_of(const StoredRun &run, const scene::Scene &scene);

} // namespace rimpact::calibration

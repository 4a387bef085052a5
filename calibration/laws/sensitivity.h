/// Near grazing the peak impact force is a nearly singular function of everything (thesis notes, 1): the
/// amplitude at which the rim is first touched, and the band in which approach speed and force move for
/// changes nobody controls.
#pragma once
#include "reduced_models/simulate.h"
#include "scene/scene.h"
#include <optional>

namespace rimpact::calibration {

struct Band {
  double nominal, low, high;
};
struct GrazingReport {
  std::string scene;
  double scale;                               ///< of the scene as given
  std::optional<double> critical_scale;       ///< at which the rim is first touched
  std::optional<double> critical_amplitude_g; ///< ricker only
  Band approach_speed;                        ///< of the first impact [m/s], 0: missed
  Band peak_force;                            ///< impact [N]
  std::vector<std::string> varied;            ///< what the band covers
};
/// Reduced model of the scene as it stands: amplitude +-0.2 %, g 9.81 / 9.80665, integrator tolerance x 1e3.
GrazingReport grazing_report(const scene::Scene &scene);

} // namespace rimpact::calibration

/// Scales of a Ricker pulse at which a bearing meets its rim at given speeds, by the reduced model.
#pragma once
#include "scene/scene.h"
#include <optional>
#include <string>
#include <vector>

namespace rimpact::app {

/// Approach speeds at the rim that the pulses of `main` are to span [m/s].
struct SpeedRange {
  double low = 0.05, high = 0.6;
};

struct ScaledPulse {
  double scale; ///< four decimals
  double speed; ///< fastest approach at that scale, by the reduced model [m/s]
  bool fitted;  ///< false: predicted, near but beyond first touch
};

struct PulseScales {
  std::optional<double> first_touch = {}; ///< scale; empty: none up to 3
  std::vector<ScaledPulse> pulses = {};   ///< the hardest first
  std::vector<std::string> left_out = {}; ///< a sentence for each that no scale up to 3 reaches
};

/// Three scales: one to predict at twice the range's low end, two to fit at its middle and its high end. Rung rim flies
/// by this very model, so that its first touch is exact; the stacked rungs are scouted with the pad's and the socket's
/// terms. A speed that needs a scale beyond 3, or at which the slider leaves the dish, is left out with a sentence.
PulseScales pulse_scales(scene::Scene pulse, const SpeedRange &range);

/// At least two decimals, and as many as a value of at most four needs: "1.05", "1.1564".
std::string in_a_name(double value);

} // namespace rimpact::app

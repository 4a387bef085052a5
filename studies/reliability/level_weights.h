/// The failure rate of a fragility that is known at levels of intensity: a weighted sum of its probabilities.
#pragma once
#include "studies/reliability/hazard.h"
#include <vector>

namespace rimpact::reliability {

/// Weights w_i [1/year] of rate = sum w_i P_i, P_i at growing intensities. The fragility is straight in the logarithm
/// of intensity between levels. Below the first it falls straight to 0 over the step of the first two levels; with one
/// level only it is 0 there. Above the last it stays: what is above may fail surely, see `most`.
struct LevelWeights {
  /// What P at the two ends of a step between levels is multiplied with [1/year].
  struct Step {
    double at_low = 0, at_high = 0;
  };
  std::vector<double> weights;
  std::vector<Step> steps = {}; ///< one between each two levels
  double below = 0;             ///< part of the first weight from intensities below the first level [1/year]
  double above = 0; ///< part of the last weight from intensities above the last level [1/year]: the hazard there

  /// Annual rate; `probabilities` in [0, 1], one a level.
  double rate(const std::vector<double> &probabilities) const;
  /// The rate if every intensity above the last level failed: no fragility that grows gives more from there.
  double most(const std::vector<double> &probabilities) const;
};

/// Throws InputError where there is no level or the intensities do not grow.
LevelWeights level_weights(const HazardCurve &hazard, const std::vector<double> &intensities);

} // namespace rimpact::reliability

/// Annual rate and probability in a lifetime of exceeding a limit state.
#pragma once
#include "studies/reliability/hazard.h"
#include <functional>
#include <vector>

namespace rimpact::reliability {

/// Probability of exceeding the limit at an intensity > 0, in [0, 1].
using Fragility = std::function<double(double)>;

/// One point of a fragility curve: intensity > 0, probability in [0, 1].
struct FragilityPoint {
  double intensity, probability;
};

/// Straight lines in the logarithm of intensity between levels. Below the first level the probability is 0,
/// above the last it stays: FailureRate::above tells how much rests on that. Throws InputError where there is
/// no point, intensities do not grow, or a probability lies outside [0, 1].
Fragility interpolated(std::vector<FragilityPoint> points);

/// Share of the rate that intensities in [low, high] contribute [1/year].
struct RateShare {
  double low, high, rate;
};

/// lambda = integral of P(x) |d lambda_IM(x)| (thesis (2-29), (4-7)).
struct FailureRate {
  double rate = 0;               ///< [1/year], `above` included
  double above = 0;              ///< part of it from intensities beyond the last edge, P held at its value there
  std::vector<RateShare> shares; ///< between successive edges: disaggregation by intensity
};

/// Integrates between successive `edges` (growing intensities > 0, at least two; kinks of the fragility
/// belong among them; those of the hazard are added). Intensities below the first edge are left out. Relative
/// error of each share below 1e-9 for a smooth fragility. Throws InputError on edges that do not grow.
FailureRate failure_rate(const HazardCurve &hazard, const Fragility &fragility, const std::vector<double> &edges);

/// Poisson: probability of at least one event in `years` >= 0 at `rate` >= 0 [1/year] (thesis (2-30), (4-8)).
double probability_in(double years, double rate);

} // namespace rimpact::reliability

/// Responses of one system at one level of intensity, and the probability that they exceed a limit.
#pragma once
#include "studies/reliability/lognormal.h"
#include <optional>
#include <vector>

namespace rimpact::reliability {

/// Distribution of a response by total probability (thesis 2.6.6, 4.6: collapses are left out of the
/// lognormal fit):
///   P(Y > y) = n_collapsed / n + n_positive / n x P(lognormal > y),  n = n_collapsed + n_zero + n_positive.
/// A response of 0 (the rim force of a run without an impact) exceeds no limit and has no logarithm; a
/// collapse exceeds every limit.
struct LevelDistribution {
  int n_collapsed = 0, n_zero = 0, n_positive = 0;
  std::optional<LognormalFit> fit; ///< of the positive responses; none where there is none
  /// P(Y > limit), limit > 0. One positive response, or equal ones, are a step. Throws InputError at limit <=
  /// 0.
  double exceedance(double limit) const;
};

/// `responses` of the runs that did not collapse, >= 0, any order. Throws InputError where there is no run at
/// all, where n_collapsed < 0, or where a response is negative or not finite.
LevelDistribution level_distribution(const std::vector<double> &responses, int n_collapsed);

} // namespace rimpact::reliability

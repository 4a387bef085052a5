/// Lognormal distribution of a response: maximum-likelihood fit with its intervals.
#pragma once
#include <vector>

namespace rimpact::reliability {

struct Interval {
  double low, high;
};

/// A lognormal distribution: the logarithm is normal of mean `mean_ln` and deviation `sigma_ln` >= 0.
/// `sigma_ln` = 0 is a step at exp(mean_ln).
struct Lognormal {
  double mean_ln = 0, sigma_ln = 1;
  /// P(Y > y), y >= 0. At a step, y equal to it is not exceeded.
  double exceedance(double y) const;
  /// Value not exceeded with probability p in (0, 1).
  double quantile(double p) const;
};

/// Maximum-likelihood fit of n values: sigma_ln is the root of the sum of squares over n (not n - 1).
struct LognormalFit {
  Lognormal distribution;
  int n = 0;
  /// Exact intervals of a normal sample: Student's t for the mean, chi-square for the deviation.
  /// `confidence` in (0, 1). Throws InputError where n < 2: one value has no interval.
  Interval mean_interval(double confidence) const;
  Interval sigma_interval(double confidence) const;
};

/// Throws InputError where there is no value, or one is not finite or not > 0.
LognormalFit fit_lognormal(const std::vector<double> &values);

} // namespace rimpact::reliability

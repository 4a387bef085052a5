/// How the share of runs that do something grows with intensity: a curve by maximum likelihood over all levels at once.
#pragma once
#include <optional>
#include <vector>

namespace rimpact::reliability {

/// Share in [0, 1] of what happens at an intensity > 0, of `weight` > 0 trials; neither need be whole.
struct ShareAt {
  double intensity, share, weight;
};

enum class Link {
  logit, ///< p = 1 / (1 + exp(-(a + b ln x)))
  probit ///< p = Phi(a + b ln x): lognormal in x, of median exp(-a / b) and deviation 1 / b
};

struct BinomialFit {
  Link link = Link::probit;
  double a = 0, b = 1; ///< b > 0
  double at(double intensity) const;
  double median() const;                     ///< intensity at which the share is one half
  double deviation() const { return 1 / b; } ///< of ln x, for a probit
};

/// Largest likelihood of the shares as parts of their weights (binomial, by Fisher's scoring). Only the weights' ratios
/// count. None: fewer than two levels have a share between 0 and 1, where the likelihood has no peak, or it does not
/// grow with intensity.
std::optional<BinomialFit> fit_binomial(const std::vector<ShareAt> &levels, Link link);

/// Probability of shares as far from the curve as these (Pearson's chi-square, weights as trials, two parameters
/// fitted). 1 where nothing is left to test.
double test_of_fit(const BinomialFit &fit, const std::vector<ShareAt> &levels);

} // namespace rimpact::reliability

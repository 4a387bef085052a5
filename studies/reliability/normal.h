/// The standard normal distribution, with all the digits of a double in both tails.
#pragma once

namespace rimpact::reliability {

/// A score farther out has a probability that leaves the numbers of a double.
inline constexpr double farthest_score = 37;

double normal_density(double score);
/// Phi(score); of 1 - Phi ask for -score.
double normal_probability(double score);
/// The score of a probability: at most farthest_score in size, which 0 and 1 have.
double standard_score(double probability);

} // namespace rimpact::reliability

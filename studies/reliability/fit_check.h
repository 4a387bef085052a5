/// Whether the runs of a study bear the lognormals that were fitted to them, as far as one limit goes.
#pragma once
#include <vector>

namespace rimpact::reliability {

/// A limit at one level of intensity.
struct LevelEvidence {
  double fitted;    ///< P by the lognormal, collapses and zeros counted
  double counted;   ///< share of the runs beyond the limit
  double n_records; ///< independent trials: all runs of a record count as one
  double n_fitted;  ///< of them, those the lognormal is fitted to
};

struct LevelCheck {
  double low = 0, high = 1; ///< what the counts allow
  bool refused = false;     ///< the lognormal does not hold here: `counted` stands for it
};

/// At levels of growing intensity, of a fragility that grows. `confidence` in (0, 1), both tails alike.
///   low and high: Clopper and Pearson's interval (Biometrika 26, 1934) of the counted share, the narrowest that any
///   pooling with higher levels (high) or lower ones (low) gives: none of them exceeds less, or more, often.
///   A lognormal is refused where its P lies outside of it; where it and that of a higher level contradict each other,
///   the fragility falling by more than the fits' own scatter explains; and, below a refused level, wherever no run
///   exceeds the limit: what bends the responses there bends the tail that reaches it.
std::vector<LevelCheck> check_fits(const std::vector<LevelEvidence> &levels, double confidence = 0.95);

} // namespace rimpact::reliability

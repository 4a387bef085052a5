/// From responses to fragility, failure rate and probability in a lifetime, with bands from drawing records anew.
#pragma once
#include "studies/reliability/rate_range.h"
#include "studies/risk/system_sample.h"

namespace rimpact::risk {

struct Banded {
  double value = 0, low = 0, high = 0;
};

/// One limit of one system.
struct LimitResult {
  std::size_t quantity = 0; ///< of Study::limits
  double limit = 0;
  std::vector<Banded> fragility; ///< one a level
  std::vector<double> counted;   ///< share of the runs beyond the limit, one a level
  std::vector<double> fitted;    ///< the fragility by the fits alone, one a level
  std::vector<reliability::LevelCheck>
      checks;                   ///< where they do not hold the counted share is the fragility; one a level
  std::vector<bool> is_counted; ///< whether it is, one a level: the thesis's rule keeps its lognormals
  std::vector<LevelModel::Exceedance> bounds; ///< of the fragility, unfinished runs counted either way; one a level
  Banded rate, probability;                   ///< [1/year]; in Study::years
  double rate_fitted = 0;                     ///< by the fits alone
  double rate_checked = 0;                    ///< by the counted share where the runs refuse the fit
  double rate_flat = 0;                       ///< straight between levels, flat above the last: the thesis's reading
  std::vector<double> of_levels;              ///< parts of the rate that rest on each level, see level_rate.h
  /// The curve over all levels that the rate takes beyond them, and the probability of levels as far from it.
  std::optional<reliability::BinomialFit> across;
  double test_across = 1;
  reliability::RateRange range;                             ///< what is assumed between and beyond the levels
  double probability_least = 0, probability_range_most = 0; ///< of it, in Study::years; 1 where it has no upper end
  double below = 0, above = 0;    ///< parts of the rate from intensities below the first and above the last level
  double probability_most = 0;    ///< in Study::years, if all intensities above the last level failed
  int n_unknown = 0;              ///< runs that stopped short of the limit, over all levels
  double if_none = 0, if_all = 0; ///< probability in Study::years, if none or all of those had exceeded it
};

/// Of the rate and its range: whether one number says it, within a tenth.
bool is_settled(const LimitResult &limit);
inline constexpr double settled_share = 0.1;

/// All limits of one system, in the order of Study::limits and their values.
std::vector<LimitResult> evaluate(const Study &study, const ResponseSet &responses, const SystemSample &sample);

/// 1 - P / P_reference; 0 where the reference never exceeds.
double reduction(double probability, double reference);
/// 1 - P / P_reference in Study::years for every limit, records drawn alike for both; 0 where P_reference is 0.
std::vector<Banded> reductions(const Study &study, const SystemSample &sample, const SystemSample &reference);

} // namespace rimpact::risk

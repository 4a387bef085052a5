/// From responses to fragility, failure rate and probability in a lifetime, with bands from drawing records anew.
#pragma once
#include "reliability/level_weights.h"
#include "risk/collect.h"
#include "risk/level_model.h"

namespace rimpact::risk {

/// What drawing records anew needs of a system's responses.
class SystemSample {
public:
  SystemSample(const Study &study, const ResponseSet &responses);

  std::size_t n_levels() const { return intensities_.size(); }
  const std::vector<double> &intensities() const { return intensities_; }
  const reliability::LevelWeights &weights() const { return weights_; }
  /// Of quantity k at a level, records counted `times`. A level of which no record was drawn keeps all of its own.
  LevelModel level(std::size_t k, std::size_t level, const std::vector<int> &times) const;
  /// P(quantity k > limit) at every level.
  std::vector<double> fragility(std::size_t k, double limit, const std::vector<int> &times) const;
  std::vector<int> once() const { return std::vector<int>(n_records_, 1); }

private:
  std::size_t n_records_;
  std::vector<double> intensities_;
  reliability::LevelWeights weights_;
  std::vector<std::vector<std::vector<reliability::RecordSums>>> sums_; ///< [quantity][level][record]
  std::vector<std::vector<std::vector<std::pair<int, double>>>>
      unfinished_; ///< [quantity][level]: record of a run that stopped, and what it reached
};

struct Banded {
  double value = 0, low = 0, high = 0;
};

/// One limit of one system.
struct LimitResult {
  std::size_t quantity = 0; ///< of Study::limits
  double limit = 0;
  std::vector<Banded> fragility;              ///< one a level
  std::vector<double> counted;                ///< share of the runs beyond the limit, one a level
  std::vector<LevelModel::Exceedance> bounds; ///< of the fragility, unfinished runs counted either way; one a level
  Banded rate, probability;                   ///< [1/year]; in Study::years
  double below = 0, above = 0;    ///< parts of the rate from intensities below the first and above the last level
  double probability_most = 0;    ///< in Study::years, if all intensities above the last level failed
  int n_unknown = 0;              ///< runs that stopped short of the limit, over all levels
  double if_none = 0, if_all = 0; ///< probability in Study::years, if none or all of those had exceeded it
};

/// All limits of one system, in the order of Study::limits and their values.
std::vector<LimitResult> evaluate(const Study &study, const ResponseSet &responses, const SystemSample &sample);

/// 1 - P / P_reference; 0 where the reference never exceeds.
double reduction(double probability, double reference);
/// 1 - P / P_reference in Study::years for every limit, records drawn alike for both; 0 where P_reference is 0.
std::vector<Banded> reductions(const Study &study, const SystemSample &sample, const SystemSample &reference);

} // namespace rimpact::risk

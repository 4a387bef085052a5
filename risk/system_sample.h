/// The responses of one system as its statistics need them, and which lognormals its runs bear.
#pragma once
#include "reliability/fit_check.h"
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
  /// P(quantity k > its limit j) by such a model, or, where the lognormal is refused, by the runs as counted.
  LevelModel::Exceedance exceedance(std::size_t k, std::size_t j, std::size_t level, const LevelModel &model,
                                    const std::vector<int> &times) const;
  /// At every level.
  std::vector<double> fragility(std::size_t k, std::size_t j, const std::vector<int> &times) const;
  const reliability::LevelCheck &check(std::size_t k, std::size_t j, std::size_t level) const {
    return limits_[k][j].checks[level];
  }
  std::vector<int> once() const { return std::vector<int>(n_records_, 1); }

private:
  struct OfLimit {
    double limit;
    std::vector<std::vector<int>> n_beyond; ///< [level][record]: finished runs beyond it
    std::vector<reliability::LevelCheck> checks;
  };
  OfLimit of_limit(const ResponseSet &responses, std::size_t k, double limit) const;
  std::vector<int> counted_times(std::size_t k, std::size_t level, const std::vector<int> &times) const;

  std::size_t n_records_;
  std::vector<double> intensities_;
  reliability::LevelWeights weights_;
  std::vector<std::vector<std::vector<reliability::RecordSums>>> sums_; ///< [quantity][level][record]
  std::vector<std::vector<std::vector<std::pair<int, double>>>>
      unfinished_;                           ///< [quantity][level]: record of a run that stopped, and what it reached
  std::vector<std::vector<OfLimit>> limits_; ///< [quantity][limit]
};

/// Share of a level's runs beyond the limit, collapses among them; those that stopped short of it are left out.
double counted_share(const ResponseLevel &level, std::size_t k, double limit);

} // namespace rimpact::risk

/// The responses of one system as its statistics need them, and which lognormals its runs bear.
#pragma once
#include "studies/reliability/fit_check.h"
#include "studies/reliability/level_rate.h"
#include "studies/risk/collect.h"
#include "studies/risk/level_model.h"

namespace rimpact::risk {

/// What drawing records anew needs of a system's responses.
class SystemSample {
public:
  SystemSample(const Study &study, const ResponseSet &responses);

  std::size_t n_levels() const { return intensities_.size(); }
  const std::vector<double> &intensities() const { return intensities_; }
  const reliability::LevelWeights &weights() const { return weights_; }
  /// Of quantity k at every level, records counted `times`. A level of which no record was drawn keeps all of its own.
  std::vector<LevelModel> levels(std::size_t k, const std::vector<int> &times) const;
  /// P(quantity k > its limit j) by such a model, or, where the lognormal is refused, by the runs as counted.
  LevelModel::Exceedance exceedance(std::size_t k, std::size_t j, std::size_t level, const LevelModel &model,
                                    const std::vector<int> &times) const;
  /// At every level, for models of `levels`.
  std::vector<double> fragility(std::size_t k, std::size_t j, const std::vector<LevelModel> &models,
                                const std::vector<int> &times) const;
  /// The curve over all levels through their probabilities; none: the study's rule has none, or they give none.
  std::optional<reliability::BinomialFit> across(const std::vector<double> &probabilities) const;
  /// Probability of shares as far from that curve as these.
  double test_of(const reliability::BinomialFit &across, const std::vector<double> &probabilities) const;
  /// By the study's rule.
  reliability::LevelRate rate(const std::vector<double> &probabilities) const;
  /// Whether the counted share stands there: the runs refuse the fit, and the study's rule heeds them.
  bool is_counted(std::size_t k, std::size_t j, std::size_t level) const {
    return rule_ != FragilityRule::thesis && check(k, j, level).refused;
  }
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
  /// Of a quantity at a level: sums of each record.
  struct LevelSums {
    std::vector<reliability::RecordSums> all, hit, free; ///< collapses are in `all` alone
    std::vector<std::pair<int, double>> unfinished;      ///< record of a run that stopped, and what it reached
    explicit LevelSums(std::size_t n_records) : all(n_records), hit(n_records), free(n_records) {}
  };
  /// `stop`: 0 where there is none; of hit runs what is beyond it counts.
  static LevelSums sums_of(const ResponseLevel &level, std::size_t k, std::size_t n_records, double stop);
  OfLimit of_limit(const ResponseSet &responses, std::size_t k, double limit,
                   const std::vector<LevelModel> &models) const;
  std::vector<int> counted_times(const LevelSums &level, const std::vector<int> &times) const;
  void set_hits_apart(std::size_t k, const std::vector<int> &times, std::vector<LevelModel> &models) const;
  std::vector<reliability::ShareAt> shares(const std::vector<double> &probabilities) const;

  FragilityRule rule_;
  reliability::HazardCurve hazard_;
  std::size_t n_records_;
  std::vector<double> intensities_, n_trials_; ///< of each level: records of different responses
  reliability::LevelWeights weights_;
  std::vector<std::vector<LevelSums>> sums_; ///< [quantity][level]
  std::vector<std::optional<double>> stops_; ///< of each quantity: where a stop caps it
  std::vector<std::vector<OfLimit>> limits_; ///< [quantity][limit]
};

/// Where the rim caps the travel (hit_level.h). None for other quantities, and where runs contradict it.
std::optional<double> stop_of(const Study &study, const ResponseSet &responses, std::size_t k);

/// Share of a level's runs beyond the limit, collapses among them; those that stopped short of it are left out.
double counted_share(const ResponseLevel &level, std::size_t k, double limit);

} // namespace rimpact::risk

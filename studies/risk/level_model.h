/// Probability that a response of one system at one level exceeds a limit, runs that stopped before their end among
/// them.
#pragma once
#include "studies/reliability/hit_level.h"
#include <utility>
#include <vector>

namespace rimpact::risk {

/// A run that stopped where its model holds no longer has exceeded what it reached by then; of higher limits it says
/// nothing. With n finished runs, e unfinished ones beyond the limit and u that are short of it:
///   P = (n P_finished + e) / (n + e), the u left out;
///   between (n P_finished + e) / (n + e + u), none of them exceeds, and (n P_finished + e + u) / (n + e + u), all do.
struct LevelModel {
  reliability::LevelDistribution finished;    ///< one lognormal of all
  std::optional<reliability::HitLevel> apart; ///< runs that hit the rim apart; none: `finished` stands for P_finished
  std::vector<std::pair<double, int>> unfinished; ///< largest value by the stop (NaN: unknown), how often it counts

  struct Exceedance {
    double value, least, most; ///< P and its bounds, least <= value <= most
    int n_unknown;             ///< u
  };
  /// limit > 0.
  Exceedance exceedance(double limit) const;
  double finished_exceedance(double limit) const; ///< P_finished
  /// With that many of the finished runs beyond it, as counted, in the place of the lognormal's.
  Exceedance exceedance(double limit, double n_finished_beyond) const;
};

} // namespace rimpact::risk

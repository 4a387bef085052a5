/// Where a constant (k_i, e) serves: the widest range of speeds over which one pair meets peak force and
/// rebound, fitted and predicted.
#pragma once
#include "calibration/laws/law_ranking.h"

namespace rimpact::calibration {

struct PairRange {
  std::string law;                        ///< whose pair it is
  double tolerance;                       ///< on peak force and rebound [-]
  FitResult result;                       ///< of the runs inside
  double from, to;                        ///< approach speeds of the runs inside [m/s]
  std::vector<LawError> inside;           ///< fitted, by speed
  std::vector<LawError> left_out;         ///< each predicted by the pair fitted to the others inside
  std::vector<LawError> outside;          ///< predicted, by speed
  double mass;                            ///< supported, for which the pair holds [kg]
  double worst_peak_force, worst_rebound; ///< of fitted and left out, absolute relative [-]
  std::string sentence;                   ///< what to type, where, and how far off it then is
};

/// `law` reads k_i and e alone. A set is of at least three runs of neighbouring speeds. It serves where its own pair,
/// fitted to peak force and rebound, meets them in every run of it, fitted and left out. Of those that serve within the
/// first of `tolerances` that any meets, the one with the widest ratio of speeds. Grazing runs take no part. Empty:
/// none.
std::optional<PairRange> pair_range(const std::vector<const StoredRun *> &runs, const FitOptions &options,
                                    const std::string &law = "no-tension",
                                    const std::vector<double> &tolerances = {0.05, 0.10, 0.20});

} // namespace rimpact::calibration

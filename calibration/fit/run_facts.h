/// What a run folder says of itself beside its response: who made it, how it ended, what it doubts. And which runs of a
/// calibration are therefore left out of the fit, or count less.
#pragma once
#include "calibration/fit/fit.h"
#include "responses/foot_report.h"
#include "responses/steel_report.h"

namespace rimpact::calibration {

struct RunFacts {
  std::string name; ///< the folder's last part
  RunSource source = RunSource::measured;
  std::optional<scene::Rung> rung; ///< empty: not finite elements
  std::optional<int> mesh;         ///< of finite elements
  RunStatus status = RunStatus::done;
  std::vector<std::string> warnings;  ///< sentences of summary.json
  double imbalance = 0;               ///< share of the energy put in that is not accounted for, signed [-]
  std::optional<JudgedStrain> strain; ///< of the rim's steel
  SteelReport steel;                  ///< by its places; empty: not known
  std::optional<FootReport> foot;     ///< of the rim's foot; none: not known
  bool beyond_rim = false;            ///< pressed deeper than the rim is thick: the run says it is no result
  double seconds = 0;                 ///< wall time [s]; 0: not known
};
/// Of a run folder's summary.json or of a mapping file. A folder without a summary holds measured curves. Throws
/// DataError where summary.json is no JSON.
RunFacts run_facts(const std::string &folder);

/// Above it the forces of a run are said to be as uncertain as its energy; above the second it is not fitted [-].
inline constexpr double usual_imbalance = 1e-3, largest_imbalance = 0.02;

/// Takes out of `runs` those that stopped early (unless `keep_stopped`), those beyond their rim and those whose energy
/// is off by more than largest_imbalance; adds the imbalance, beyond the usual one, to the stated uncertainty of the
/// force of the others. Returns a sentence a run that is touched. Throws DataError when none is left.
std::vector<std::string> screen(std::vector<StoredRun> &runs, const std::map<std::string, RunFacts> &facts,
                                const Uncertainty &stated, bool keep_stopped);

} // namespace rimpact::calibration

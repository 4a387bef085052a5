/// The runs of one system as numbers: responses by quantity, level and record.
#pragma once
#include "studies/fleets/implausible_runs.h"
#include "studies/reliability/record_sums.h"
#include "studies/risk/systems.h"
#include <map>

namespace rimpact::risk {

/// A run of a level.
struct Response {
  int record;                 ///< of ResponseSet::records
  bool beyond;                ///< collapsed, or left the dish
  std::vector<double> values; ///< of Study::limits, >= 0; NaN where the run's table has no such column
  std::vector<double> inputs; ///< of ResponseSet::inputs
  bool hit = false;           ///< it touched the rim
};

struct ResponseLevel {
  double intensity_g = 0;
  int n_records = 0;          ///< records of different responses: a record given twice is one trial
  std::vector<Response> runs; ///< those with a result
  /// Refused, failed, or stopped where their model holds no longer, or went deeper into the rim than it is thick:
  /// values are what was reached by then, NaN unknown.
  std::vector<Response> unfinished;
  fleets::HitShares hits = {}; ///< of all its runs
};

struct ResponseSet {
  std::vector<std::string> records;  ///< names, over all levels; the same for every system of a study
  std::vector<std::string> inputs;   ///< sampled keys
  std::vector<ResponseLevel> levels; ///< of Motions::levels that have a run with a result
  int n_through_rim = 0;             ///< runs that went deeper into the rim than it is thick: among the unfinished
  fleets::ImplausibleRuns implausible = {}; ///< of all its runs, by [plausible] of the study
  int n_past_wall = 0;                      ///< runs without a rim that went as far past its wall: among the finished
  TableShape runs = {};                     ///< of its table
};

/// From the table.csv in a system's folder. Throws DataError where it is damaged, lacks runs, or holds no run with a
/// result at any level; InputError for a limit whose quantity no run has.
ResponseSet collect(const Study &study, const std::string &folder, const Motions &motions);

} // namespace rimpact::risk

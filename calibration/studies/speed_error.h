/// Speed against error: runs of one scene with more and less expensive settings, each compared with the most
/// expensive.
#pragma once
#include "calibration/data/metrics.h"
#include "responses/choices.h"

namespace rimpact::calibration {

/// A run that ended well, and what it cost.
struct StudyRun {
  std::string name;
  SolvedBy rung = SolvedBy::reduced;
  std::string element;             ///< of a reduced run: law, numbers and their source; empty: finite elements
  bool on_curve = false;           ///< a reduced run on the rim's own curve
  int mesh = 0;                    ///< 1 | 2 | 3; 0: none
  double step = 0;                 ///< in contact [s]; 0: the plan's
  double seconds = 0, memory = 0;  ///< wall time [s], peak [bytes]
  std::optional<double> processor; ///< time of all ranks [s], which does not depend on what else the machine does
  double cost() const { return processor.value_or(seconds); }
  long n_dofs = 0;
  double imbalance = 0;             ///< of the energy, relative
  std::optional<double> peak_force; ///< of impact [N]
  double dissipated = 0;            ///< by friction, plasticity and the reduced impact [J]
  Response response;
};
/// From a run folder's summary (summary.json) and response. Throws DataError where a figure is missing.
StudyRun study_run(const std::string &name, const nlohmann::json &summary, Response response);

struct StudyRow {
  StudyRun run;
  Comparison errors;                      ///< against the reference
  std::optional<double> dissipated_error; ///< [-]; none: the reference ends at another instant
  double error = 0; ///< what the frontier is drawn of: of the peak force, without impact of the displacement [-]
  bool reference = false, on_frontier = false;
};
struct SpeedError {
  std::vector<StudyRow> rows;         ///< cheapest first
  bool touches = true;                ///< errors are of the peak force; else, with no impact, of the displacement
  std::optional<double> order;        ///< observed over three meshes of the reference's rung, in h
  std::optional<double> extrapolated; ///< peak force at h -> 0 [N]; then `error` is against it
  std::string recommended;            ///< cheapest with an error below the wanted one; "": none
  double wanted = 0;
};
/// The reference is the run of the highest rung (a rim's own curve above other elements), there of the finest mesh,
/// there of the smallest step. With three meshes of it that converge with an order between 0.5 and 5 the peak force is
/// extrapolated (Richardson, h by 1.5). Throws InputError for fewer than two runs or wanted <= 0.
SpeedError speed_against_error(std::vector<StudyRun> runs, double lateral_capacity, double wanted);

} // namespace rimpact::calibration

/// Which impact law serves: each fitted to the same impacts, ranked by what it leaves unexplained, and each
/// asked to predict runs it has not been fitted to.
#pragma once
#include "calibration/fit/fit.h"

namespace rimpact::calibration {

/// Errors of one law in one run, each impact restarted from the reference's own state.
struct LawError {
  std::string folder;
  double speed;              ///< largest approach speed of the run's impacts [m/s]
  double peak_force;         ///< signed relative, of the hardest impact [-]; these five: NaN where not known
  double depth;              ///< signed relative, of the hardest impact's penetration [-]
  double rebound;            ///< signed, over the reference's rebound speed [-]
  double unexplained;        ///< root mean square of the force's difference over that of the force [-]
  double nrmse_displacement; ///< from rest, over L_c, as docs/interface.md defines it [-]
  bool grazing;              ///< every impact of the run grazes: said, never counted
};
/// Fitted without the runs named, asked for these.
struct LeftOut {
  std::string what; ///< a run folder, or "pulse 0.78 g, 1 s"
  std::vector<LawError> errors;
  bool converged;
};
struct LawRow {
  FitResult result; ///< of all runs; result.law names the law
  std::vector<LawError> fitted;
  std::vector<LeftOut> left_out;
  /// Root mean square over the fitted runs [-]. This and the largest errors below: empty where there is no run to judge
  /// by, or one that cannot be judged.
  std::optional<double> unexplained;
  std::optional<double> largest_peak_error, largest_rebound_error;   ///< fitted
  std::optional<double> left_out_peak_error, left_out_rebound_error; ///< over runs left out one at a time
  /// Speeds (neighbouring) at which the left-out peak force and rebound both stay within the tolerance.
  std::optional<double> valid_from, valid_to;
  int n_valid = 0; ///< runs in that range
  std::string sentence;
  std::string held; ///< which exponents were not fitted, and why; empty: none
};
struct LawRanking {
  double tolerance = 0.05;
  std::vector<LawRow> rows; ///< the best first
  std::string sentence;     ///< for engineers
};

/// Whether some impact law reads the parameter.
bool of_a_law(const std::string &parameter);
/// `given` for another law: its own parameters, what is held or bounded where it reads that, fewer starts.
FitOptions options_for(const std::string &law, const FitOptions &given);

/// Of the runs left out one at a time, by speed; grazing ones apart.
std::vector<LawError> left_out_runs(const LawRow &row);

/// What a fit of `runs` leaves, on those it saw and on each left out.
LawRow judged(const std::vector<const StoredRun *> &runs, const FitOptions &options, const FitResult &result,
              double tolerance = 0.05);

/// `runs` are fitted, grazing impacts apart. Laws that cannot be fitted are left out with a note.
LawRanking rank_laws(const std::vector<const StoredRun *> &runs, const std::vector<std::string> &laws,
                     const FitOptions &options, std::vector<std::string> &notes, double tolerance = 0.05);

} // namespace rimpact::calibration

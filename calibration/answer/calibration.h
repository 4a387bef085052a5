/// The verb `calibrate`: from run folders to fitted parameters, predictions and their range of validity.
///
/// Runs are told apart by their scene: isolated impacts (`window`) and histories. With histories among the
/// runs to fit, the constant parameters come from these and the windows give k_i(v), e(v) and the range in
/// which the constant pair holds; with windows alone, the parameters are the best constant ones over all of
/// them.
#pragma once
#include "calibration/answer/steel_band.h"
#include "calibration/data/metrics.h"
#include "calibration/fit/impact_curves.h"
#include "calibration/fit/profile.h"
#include "calibration/fit/run_facts.h"
#include "calibration/laws/pair_range.h"
#include "calibration/laws/sensitivity.h"
#include "calibration/laws/speed_law.h"
#include <memory>

namespace rimpact::calibration {

struct CalibrationOptions {
  FitOptions fit;
  WindowOptions window;
  std::vector<std::string> predict; ///< run folders not fitted, only predicted
  bool grazing_reports = true;      ///< critical amplitudes of the Ricker scenes at scale 1
  double validity_tolerance = 0.10; ///< on the peak force, over speed
  std::vector<std::string> laws =
      {};                    ///< impact laws to rank on all runs to fit; the best valid one is the answer, or fit.law
  bool keep_stopped = false; ///< fit runs that ended early too
  bool profiles = true;      ///< profile likelihood of every parameter (two or more)
  std::optional<SteelBand> steel_band = {}; ///< of windows beside the runs, for the answer
};

/// An impact restarted from the reference's state, with the fitted values.
struct ImpactCheck {
  double touch_time, approach_speed; ///< of the reference [s], [m/s]
  double peak_force_error;           ///< signed relative [-]
  double rebound_error;              ///< of the radial speed at release, over the approach speed [-]
  double normalised_force;           ///< reference F / (v sqrt(k m)) [-]
  bool fitted, grazing, dented;
};
/// A run against the reduced model, simulated from rest with the fitted values.
struct RunCheck {
  Comparison history;
  std::optional<Comparison>
      published; ///< the same with the published k_i, e, for the bearing and mass they were published for
  std::vector<ImpactCheck> impacts;
  std::vector<std::string> notes;
};

/// Whole motions, or single impacts where there is no motion.
enum class FittedOn { histories, windows };
constexpr auto choices(FittedOn) {
  return choices_of<FittedOn>({{FittedOn::histories, "histories"}, {FittedOn::windows, "windows"}});
}

struct Answer;
struct Calibration {
  FitResult result;
  FittedOn fitted_on = FittedOn::histories;
  std::map<std::string, RunCheck> fit, prediction; ///< by run folder
  std::optional<WindowsTable> windows;
  std::vector<SpeedLaw> speed_laws;
  std::map<std::string, Profile> profiles; ///< by parameter
  LawRanking laws;
  std::optional<PairRange> pair_range;  ///< where laws are ranked: the widest range of a constant pair that cannot pull
  std::shared_ptr<const Answer> answer; ///< see answer.h
  std::vector<GrazingReport> grazing;
  ImpactCurves curves;                   ///< of the answer's law
  scene::Scene scene;                    ///< the first fitted run's, with the fitted values: mass, law, friction
  std::map<std::string, RunFacts> facts; ///< by run folder
  std::vector<std::string> doubts;       ///< of runs: what they say of themselves, and what was left out or counts less
  std::vector<std::string> notes;
};

/// Published for shfps-225 (thesis 2.5.3).
inline constexpr double published_k_i = 4.5e8; ///< [N/m]
inline constexpr double published_e = 0.65;

/// Throws InputError (options, runs of different bearings, masses, loads or laws), DataError (no impact, too
/// few samples, unreadable run), each naming the folder.
Calibration calibrate(const std::vector<std::string> &run_folders, const CalibrationOptions &options = {});

/// Throws GateError when the fit did not converge; call it after writing.
void check_gate(const Calibration &calibration);

} // namespace rimpact::calibration

/// Least-squares fit of reduced-model parameters to the impacts of stored runs ("impact-wise shooting").
///
/// Each impact is restarted from the reference's own state just before touch and integrated, ground motion
/// and friction included, through contact to shortly after release. It contributes four groups of residuals,
/// each a difference over its stated uncertainty. A group counts as one observation, so that neither the number of
/// samples nor the duration weighs:
///   force         radial rim force where the reference exceeds 5 % of its peak (a `signed` law pulls before
///   release,
///                 where a real rim is silent: that tension is a property of the law, not of the data)
///   displacement  radial travel from start to end
///   rebound       inward radial speed at release, each at its own
///   peak          peak force
/// Where the clock of force and displacement is uncertain (Uncertainty::time), each impact may be shifted by
/// the time that serves it best. Its price is a fifth group, `phase`: shift over its uncertainty.
/// Parameters that the flight informs on (mu_fast, ...) add a group for the motion before the first touch.
#pragma once
#include "calibration/data/impact_window.h"
#include "calibration/fit/fit_options.h"
#include "calibration/fit/parameter.h"
#include <map>
#include <optional>

namespace rimpact::calibration {

/// What the data say of a parameter.
enum class Verdict {
  determined,
  grazing,     ///< every impact only grazes the rim
  bound,       ///< it ended at one of its bounds
  flat,        ///< the data leave it open
  noise,       ///< the record's noise hides it
  model_misfit ///< determined, but the law does not follow the data
};
constexpr auto choices(Verdict) {
  using enum Verdict;
  return choices_of<Verdict>({{determined, "determined"},
                              {grazing, "grazing"},
                              {bound, "bound"},
                              {flat, "flat"},
                              {noise, "noise"},
                              {model_misfit, "form"}});
}

struct Estimate {
  double value = 0, standard_error = 0;       ///< reported unit
  double stated_error = 0;                    ///< standard error from the stated uncertainties alone
  double interval_low = 0, interval_high = 0; ///< 95 %
  bool identifiable = true;
  bool at_bound = false;
  std::string reason; ///< when not identifiable
  Verdict verdict = Verdict::determined;
};

/// The force channel as the fit finds it, beside what was stated.
struct ChannelGain {
  double factor;         ///< reading over force [-]
  double standard_error; ///< [-]
  double stated;         ///< standard error beforehand [-]
};

struct FitResult {
  std::vector<std::string> names;
  std::string law;
  std::map<std::string, double> fixed; ///< as in FitOptions
  std::map<std::string, Estimate> parameters;
  std::map<std::string, std::map<std::string, double>> correlation;
  double condition = 0; ///< of the Jacobian in relative changes of the parameters
  double cost = 0;      ///< half the sum of squares
  int n_impacts = 0, n_residuals = 0, n_starts = 0;
  int n_starts_agreeing = 0; ///< that ended within 1e-3 of the same values
  int n_evaluations = 0;
  std::optional<ChannelGain> gain; ///< where a record states an error of it
  bool converged = false;
  bool within_noise = false;                         ///< the law follows every measured impact within its noise
  SampleWeighting counting = SampleWeighting::curve; ///< of measured impacts, never automatic
  std::string message;                               ///< how it ended
  std::vector<std::string> notes;
};

/// Standard errors: sandwich covariance, each group's variance the larger of the stated and the one found,
/// inflated by the residuals' autocorrelation (a model error is one error, not one a sample); intervals in
/// the fitted variable. Throws DataError when no impact is left to fit, InputError for bad options.
FitResult fit(const std::vector<const StoredRun *> &runs, const FitOptions &options);

/// Half the sum of squares with one parameter held at each of `values` (reported unit) and the others
/// refitted.
std::vector<double> profile(const std::vector<const StoredRun *> &runs, const FitOptions &options,
                            const FitResult &best, const std::string &name, const std::vector<double> &values);

/// The scene with the law and the held values of a fit, before anything is fitted.
scene::Scene with_settings(scene::Scene scene, const std::string &law, const std::map<std::string, double> &fixed);
/// The run's scene with law, held and fitted values set.
scene::Scene with_fitted(const scene::Scene &scene, const FitResult &result);

} // namespace rimpact::calibration

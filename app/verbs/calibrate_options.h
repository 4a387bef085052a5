/// The options of `rimpact calibrate`, from words to settings.
#pragma once
#include "app/console/verb.h"
#include "calibration/answer/calibration.h"

namespace rimpact::app {

/// As typed: names and NAME=VALUE pairs.
struct CalibrateWords {
  std::vector<std::string> predict, fixed, bounds, start, sigma;
  std::string fit, law, laws = "signed,no-tension,hunt-crossley,elastoplastic,bilinear";
  bool keep_stopped = false;
  double robust = calibration::FitOptions().robust_scale;
  std::optional<double> lead_mm;
  int starts = calibration::FitOptions().n_starts;
};
void add_calibrate_options(CLI::App &verb, CalibrateWords &words);
/// "none", "all" (those that are physical: not `printed`) or names with commas. Throws InputError naming the
/// known laws.
std::vector<std::string> laws_named(const std::string &list);
/// Throws InputError naming the word that is wrong.
calibration::CalibrationOptions calibrate_settings(const CalibrateWords &words);

} // namespace rimpact::app

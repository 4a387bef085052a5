#include "app/verbs/calibrate_options.h"
#include "app/words/assignments.h"
#include "io/files/text.h"
#include "laws/impact/catalogue.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

/// Travel before touch at which shots start when the rim's own place is fitted [m].
constexpr double lead_of_an_offset = 6e-3;

std::vector<std::string> names_of(const std::string &list) {
  std::vector<std::string> names;
  for (const auto part : split(list, ','))
    if (!trim(part).empty()) names.emplace_back(trim(part));
  return names;
}

calibration::Uncertainty uncertainty_of(const std::vector<std::string> &words) {
  calibration::Uncertainty u;
  double time_ms = 0;
  const std::map<std::string, double *> known = {{"force", &u.force},
                                                 {"displacement", &u.displacement},
                                                 {"speed", &u.speed},
                                                 {"gain", &u.gain},
                                                 {"time_ms", &time_ms}};
  for (const auto &[name, value] : values_of(words, "--sigma")) {
    const auto found = known.find(name);
    if (found == known.end())
      throw InputError("--sigma " + unknown_word(name, {"force", "displacement", "speed", "gain", "time_ms"}));
    *found->second = value;
    if (name == "force" && u.gain == 0) u.gain = value; // of a measured record: one error common to all of it
  }
  u.time = 1e-3 * time_ms;
  return u;
}

} // namespace

void add_calibrate_options(CLI::App &verb, CalibrateWords &words) {
  verb.add_option("--fit", words.fit, "parameters, e.g. k_i,e (default: those of the impact law)");
  verb.add_option("--predict", words.predict, "run folders to predict, not to fit");
  verb.add_option(
      "--law", words.law,
      "impact law of the fit and of the answer (default: fits the runs' own and answers with the best of --laws)");
  verb.add_option("--laws", words.laws,
                  "impact laws to rank, with leave-one-out: all, none (the law fitted is the answer) or names; seconds "
                  "to a minute")
      ->capture_default_str();
  verb.add_flag("--keep-stopped", words.keep_stopped, "fit runs that ended early too");
  verb.add_option("--fixed", words.fixed, "NAME=VALUE, held instead of fitted; repeatable");
  verb.add_option("--bounds", words.bounds, "NAME=LOW:HIGH; repeatable");
  verb.add_option("--start", words.start, "NAME=VALUE, where a search starts; repeatable");
  verb.add_option("--sigma", words.sigma,
                  "uncertainty of the runs, e.g. force=0.03 (share of the peak), displacement=0.001 (share of L_c), "
                  "speed=0.01 (share of the approach speed), time_ms=0.5 (of the clock within an impact)");
  verb.add_option("--robust", words.robust, "Huber loss beyond so many uncertainties (0: least squares)")
      ->capture_default_str();
  verb.add_option("--starts", words.starts, "searches, spread over the bounds")->capture_default_str();
  verb.add_option("--lead-mm", words.lead_mm, "travel before touch at which impacts are restarted");
}

std::vector<std::string> laws_named(const std::string &list) {
  if (list == "none") return {};
  auto laws = names_of(list == "all" ? CalibrateWords().laws : list);
  for (const auto &law : laws) laws::impact_law(law);
  return laws;
}

calibration::CalibrationOptions calibrate_settings(const CalibrateWords &words) {
  calibration::CalibrationOptions settings;
  settings.predict = words.predict;
  settings.fit.law = words.law;
  settings.fit.parameters = names_of(words.fit); // none: those of the law
  if (!words.fit.empty() && settings.fit.parameters.empty())
    throw InputError("--fit names no parameter; without it those of the impact law are fitted");
  settings.fit.fixed = values_of(words.fixed, "--fixed");
  settings.fit.bounds = ranges_of(words.bounds, "--bounds");
  settings.fit.start = values_of(words.start, "--start");
  settings.fit.uncertainty = uncertainty_of(words.sigma);
  settings.fit.robust_scale = words.robust;
  settings.fit.n_starts = words.starts;
  settings.laws = laws_named(words.laws);
  if (!words.law.empty() && !settings.laws.empty() &&
      std::find(settings.laws.begin(), settings.laws.end(), words.law) == settings.laws.end())
    settings.laws.push_back(words.law); // to be compared with the others
  settings.keep_stopped = words.keep_stopped;
  const auto &names = settings.fit.parameters;
  if (std::find(names.begin(), names.end(), "capacity_offset") != names.end() ||
      settings.fit.fixed.count("capacity_offset") > 0) { // the offset says where the rim begins, not the reference
    settings.window.touch = calibration::TouchReference::gap;
    settings.window.lead = lead_of_an_offset;
  }
  if (words.lead_mm) {
    if (!(*words.lead_mm >= 0 && *words.lead_mm <= 1000))
      throw InputError(fmt::format("--lead-mm {:g} must be in 0..1000", *words.lead_mm));
    settings.window.lead = 1e-3 * *words.lead_mm;
  }
  return settings;
}

} // namespace rimpact::app

/// `rimpact geometry --vary`: the question as it is typed, and the rims that it asks about.
#pragma once
#include "app/jobs/curve_jobs.h"
#include "app/jobs/given_case.h"
#include "calibration/studies/vary_study.h"

namespace rimpact::app {

/// As typed.
struct VaryWords {
  std::vector<std::string> vary, at, targets;
};
/// Throws InputError naming the word, what is known and the bound; for a load that nobody gave it names the key.
calibration::VaryQuestion vary_question(const VaryWords &words, const GivenCase &given);

/// --set words of the bearing with these values.
std::vector<std::string> settings_of(const calibration::VaryQuestion &question, const std::vector<double> &at);
/// "thickness_mm-50", of several keys joined by "_".
std::string name_of(const calibration::VaryQuestion &question, const std::vector<double> &at);
/// Every combination of the keys' values, the first key's fastest.
std::vector<std::vector<double>> combinations(const calibration::VaryQuestion &question);

} // namespace rimpact::app

/// Options of the form NAME=VALUE and NAME=LOW:HIGH. All throw InputError naming the option and the word.
#pragma once
#include "calibration/fit/fit.h"
#include <map>
#include <string>
#include <vector>

namespace rimpact::app {

std::map<std::string, double> values_of(const std::vector<std::string> &words, const std::string &option);
std::map<std::string, calibration::Bounds> ranges_of(const std::vector<std::string> &words, const std::string &option);

} // namespace rimpact::app

/// The varied rims as JSON, CSV and text.
#pragma once
#include "calibration/studies/vary_study.h"
#include <nlohmann/json.hpp>

namespace rimpact::calibration {

nlohmann::json to_json(const std::vector<VaryPoint> &points, const VaryQuestion &question);
/// Columns `at` and those of vary_outputs(), for a picture; null without rows.
nlohmann::json between_json(const std::vector<VaryPoint> &points);
std::string to_csv(const std::vector<VaryPoint> &points, const VaryQuestion &question);
std::string describe(const std::vector<VaryPoint> &points, const VaryQuestion &question);

} // namespace rimpact::calibration

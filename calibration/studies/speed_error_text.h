/// A study of speed against error as text, CSV and JSON.
#pragma once
#include "calibration/studies/speed_error.h"

namespace rimpact::calibration {

nlohmann::json to_json(const SpeedError &study);
std::string to_csv(const SpeedError &study);
std::string describe(const SpeedError &study);

} // namespace rimpact::calibration

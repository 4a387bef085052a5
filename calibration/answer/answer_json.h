/// An answer as JSON (docs/interface.md, calibration.json).
#pragma once
#include "calibration/answer/answer.h"

namespace rimpact::calibration {

nlohmann::json to_json(const Answer &answer);

} // namespace rimpact::calibration

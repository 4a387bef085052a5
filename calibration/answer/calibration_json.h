/// calibration.json (docs/interface.md), and calibration.toml: the answer as keys of a scene file.
#pragma once
#include "calibration/answer/calibration.h"

namespace rimpact::calibration {

nlohmann::json to_json(const Calibration &calibration);
/// Writes both files; the calibration must have its answer, into `folder`, made when absent, atomically. Throws
/// IoError.
void write_calibration(const Calibration &calibration, const std::string &folder);

} // namespace rimpact::calibration

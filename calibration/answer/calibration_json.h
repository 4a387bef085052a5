/// calibration.json (docs/interface.md), and calibration.toml: the answer as keys of a scene file.
#pragma once
#include "calibration/answer/calibration.h"

namespace rimpact::calibration {

nlohmann::json to_json(const Calibration &calibration);
/// c_i of (2-20) [N s/m]: m1 the supported mass, m2 infinite (the rim is fixed to the ground).
double damping_coefficient(const scene::Scene &scene);
/// A table for the terminal: the answer first.
std::string describe(const Calibration &calibration);
/// Writes both files; the calibration must have its answer, into `folder`, made when absent, atomically. Throws
/// IoError.
void write_calibration(const Calibration &calibration, const std::string &folder);

} // namespace rimpact::calibration

/// calibration.json (INTERFACE), and calibration.toml: the fitted values as keys of a scene file.
#pragma once
#include "calibration/calibration.h"

namespace rimpact::calibration {

nlohmann::json to_json(const Calibration &calibration);
/// c_i of (2-20) [N s/m]: m1 the supported mass, m2 infinite (the rim is fixed to the ground).
double damping_coefficient(const scene::Scene &scene);
/// `[reduced]` (and `[load]`) keys, to be pasted into a scene or bearing case.
std::string to_toml_fragment(const Calibration &calibration);
/// A table for the terminal.
std::string describe(const Calibration &calibration);
/// Writes both files into `folder`, made when absent, atomically. Throws IoError.
void write_calibration(const Calibration &calibration, const std::string &folder);

} // namespace rimpact::calibration

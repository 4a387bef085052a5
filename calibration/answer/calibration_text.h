/// A calibration as text.
#pragma once
#include "calibration/answer/calibration.h"

namespace rimpact::calibration {

/// c_i of (2-20) [N s/m]: m1 the supported mass, m2 infinite (the rim is fixed to the ground).
double damping_coefficient(const scene::Scene &scene);
/// A table for the terminal: the answer first.
std::string describe(const Calibration &calibration);

} // namespace rimpact::calibration

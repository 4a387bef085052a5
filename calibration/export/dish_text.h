/// What an exported dish approximates, in sentences.
#pragma once
#include "calibration/export/dish.h"

namespace rimpact::calibration {

/// Of a flat slider (links of SAP2000 and ETABS) and of one that rides on an ellipsoid (OpenSees), under `vertical`
/// [N].
std::vector<std::string> flat_lines(const Dish &dish, double vertical);
std::vector<std::string> riding_lines(const Dish &dish, double vertical);

} // namespace rimpact::calibration

/// A fitted law as a CSV table.
#pragma once
#include "calibration/export/exported_rim.h"

namespace rimpact::calibration {

/// Force over penetration of the law: first loading, and unloading from five depths of the exported range (laws with a
/// dashpot: impacts at five speeds).
std::string law_csv(const ExportedRim &rim, const std::vector<std::string> &header);

} // namespace rimpact::calibration

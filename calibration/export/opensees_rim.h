/// The rim as OpenSees' materials: what the law names (impact_laws), its gap springs tuned, and how far they are from
/// it.
#pragma once
#include "calibration/export/gap_springs.h"
#include "calibration/export/self_check.h"

namespace rimpact::calibration {

/// The rim's materials, the same for both languages.
struct OpenSeesRim {
  laws::OpenSeesMaterial material;
  std::vector<GapSpring> springs = {}; ///< of the material gap_springs; else empty
  SelfCheck check = {};
};
/// Throws DataError for a law that OpenSees has no material for (printed, curve).
OpenSeesRim opensees_rim(const ExportedRim &rim);

} // namespace rimpact::calibration

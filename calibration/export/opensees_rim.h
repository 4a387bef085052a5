/// The rim as OpenSees' materials: what the law names (impact_laws), its gap springs tuned, and how far they are from
/// it.
#pragma once
#include "calibration/export/gap_springs.h"
#include "calibration/export/self_check.h"

namespace rimpact::calibration {

/// The rim's materials, the same for both languages.
struct OpenSeesRim {
  laws::OpenSeesMaterial material;
  bool in_series = false;              ///< spring and dashpot behind a gap that only presses, for ViscoelasticGap pulls
  std::vector<GapSpring> springs = {}; ///< of the material gap_springs; else empty
  MakeContact contact = {};            ///< of one side, as OpenSees integrates it
  double stiffness = 0;                ///< its largest [N/m]
  SelfCheck check = {};
};
/// Throws DataError for a law that OpenSees has no material for (printed, curve).
OpenSeesRim opensees_rim(const ExportedRim &rim);
/// The whole bearing of the file: the slider rides, and the round rim of rimpact_bearing is new at every touch.
FlownBearing flown_bearing(const ExportedRim &rim, const OpenSeesRim &springs, const Dish &dish);

} // namespace rimpact::calibration

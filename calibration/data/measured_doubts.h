/// What a measured impact shows that no noise explains: a gain or a mass, a place, a clock that is off.
#pragma once
#include "calibration/data/measured_record.h"
#include "calibration/data/shot_start.h"

namespace rimpact::calibration {

struct MeasuredImpact {
  std::size_t index; ///< of the contact in its record
  const ImpactWindow &window;
  const ShotStart &start;
};

/// Adds to run.doubts, and to run.noise what is worth telling only.
void doubt(StoredRun &run, const MeasuredRecord &record, const WindowOptions &options, const MeasuredImpact &impact);

} // namespace rimpact::calibration

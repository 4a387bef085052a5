/// Impacts of a measured record, with what its noise leaves open; the estimator's equations are in
/// docs/theory/measured-curves.md.
///
/// Contacts are found by contact_detector.h. The state at a shot's start comes from the flight before it (up to 50 ms,
/// shot_start.h), never from differences of samples; so does the speed of rebound, from the flight after release. The
/// noise of the displacement is the root mean square of what these flights leave, over all impacts of the record. A
/// window record that begins at touch has no flight: its approach speed is the scene's, with the stated error.
#pragma once
#include "calibration/data/impact_window.h"

namespace rimpact::calibration {

/// Fills run.impacts, run.summary and run.notes from run.response, and leaves in the response the rim's force of
/// contacts only, freed of the cell's zero. Impacts that cannot be fitted stand in the notes with the reason.
void cut_measured(StoredRun &run, const WindowOptions &options);

} // namespace rimpact::calibration

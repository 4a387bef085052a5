/// The impact that is under way where a run stops.
#pragma once
#include "responses/summary.h"

namespace rimpact {

/// As it stands in a list where it was never released: the release lies before the touch, there is no rebound.
Impact left_open(Impact impact);

/// Whether it was never released.
bool is_open(const Impact &impact);

/// Whether so much of an impact's force is left that its rebound is not known yet [N].
bool still_bears(double force, double peak);

/// Of a run that ended while the rim was pressed: its last impact has no release (summary.json: null), and is added
/// where the run's own list does not hold it yet. Nothing changes where the last sample bears no rim force.
void leave_last_impact_open(const Response &response, Summary &summary);

} // namespace rimpact

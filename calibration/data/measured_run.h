/// Measured curves: a table of somebody else's (a laboratory's, another program's) read through a mapping file.
#pragma once
#include "calibration/data/impact_window.h"

namespace rimpact::calibration {

/// Throws InputError (the mapping: unknown signal, a unit of another kind) and DataError (the table: a
/// missing column, time running back, figures that contradict each other as wrong units do), naming file,
/// line or column.
StoredRun read_measured(const std::string &path, const WindowOptions &options);

/// Throws DataError when the force lasts so long that it would push the mass out of the bearing: before anything is
/// looked for in samples of a wrong clock.
void require_clock(const Response &response, const scene::Scene &scene, const std::string &table);
/// Throws DataError when the figures of a run contradict each other by more than a factor of three: velocity
/// against the displacement's slope; or the rim's force, by its impulse, against the motion it causes (two where
/// nothing else acts), surely by what is known of the approach speed. `force_unit`: as declared, to name a slip.
void require_consistent(const StoredRun &run, const std::string &force_unit = "");

} // namespace rimpact::calibration

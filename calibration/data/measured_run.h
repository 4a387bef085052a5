/// Measured curves: a table of somebody else's (a laboratory's, another program's) read through a mapping file.
#pragma once
#include "calibration/data/impact_window.h"

namespace rimpact::calibration {

/// Throws InputError (the mapping: unknown signal, a unit of another kind) and DataError (the table: a
/// missing column, time running back, figures that contradict each other as wrong units do), naming file,
/// line or column.
StoredRun read_measured(const std::string &path, const WindowOptions &options);

} // namespace rimpact::calibration

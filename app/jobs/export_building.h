/// rimpact export DIR --opensees, DIR the run folder of a building: its bearings, each under its own weight.
#pragma once
#include "app/console/console.h"

namespace rimpact::app {

/// Whether the folder holds a run of `rimpact building`.
bool is_building_folder(const std::string &folder);

/// bearing_N.tcl and bearing_N.py for the bearing under node N, bearings.tcl and bearings.py that place them all; the
/// paths to stdout. `header` opens every file as a comment. Throws DataError for a law that OpenSees has no material
/// for, IoError.
void export_building_bearings(const std::string &folder, const std::string &out, const std::vector<std::string> &header,
                              Console &console);

} // namespace rimpact::app

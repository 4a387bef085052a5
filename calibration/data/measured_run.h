/// Measured curves: a table of somebody else's (a laboratory's, another program's) read through a mapping
/// file.
///
///   scene = "scene.toml"            # bearing, load and, for a test on a shaking table, its excitation
///   set = ["excitation.speed_m_per_s=0.3"]   # optional, as --set
///   file = "test-07.csv"            # beside this file
///   skip_lines = 2                  # before the header line
///   force_noise = 0.02              # optional: share of the peak below which no contact is looked for; the record's
///   noise is found anyway [columns.displacement_x]        # any stored signal; time, displacement_x and impact_x (or
///   _y) are needed column = "LVDT 1"               # as the header says unit = "mm"                     # s ms m cm mm
///   N kN MN m_per_s mm_per_s factor = -1.0                   # stored = (value - zero) factor, in SI zero = 12.5 # in
///   the column's unit [uncertainty]                   # optional, instead of the fit's own: shares, and the clock
///   within an impact force = 0.02 displacement = 0.001 speed = 0.02 gain = 0.02                     # of the force
///   channel, one error common to all impacts; default: force, where that is stated time_ms = 0.2
#pragma once
#include "calibration/data/impact_window.h"
#include "calibration/data/mapping.h"

namespace rimpact::calibration {

/// Throws InputError (the mapping: unknown signal, a unit of another kind) and DataError (the table: a
/// missing column, time running back, figures that contradict each other as wrong units do), naming file,
/// line or column.
StoredRun read_measured(const std::string &path, const WindowOptions &options);

/// Throws DataError when the force lasts so long that it would push the mass out of the bearing: before anything is
/// looked for in samples of a wrong clock.
void require_clock(const Response &response, const scene::Scene &scene, const std::string &table);
/// Throws DataError when the figures of a run contradict each other by more than a factor of three: velocity
/// against the displacement's slope, or impulse of the rim force against the change of momentum.
void require_consistent(const StoredRun &run);

} // namespace rimpact::calibration

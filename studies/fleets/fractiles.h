/// Curves of an incremental dynamic analysis: fractiles over the motions at each level of intensity
/// (Vamvatsikos and Cornell, Earthquake Engineering and Structural Dynamics 31, 2002).
#pragma once
#include "io/files/table.h"

namespace rimpact::fleets {

/// One row for each value of the column `along`, growing: n_runs (done, or stopped because the slider left
/// the dish or the superstructure collapsed), n_stopped of them, n_with_impact, n_beyond_rim and n_beyond_fit
/// (limits.h; empty where it is not known of any run), n_without_result (any other: not among n_runs), n_hits and the
/// shares of them that lie beyond (hit_shares.h; empty: not known), and p16_, p50_, p84_ of peak_displacement_m,
/// peak_lateral_force_N, peak_impact_force_N and, when the table has them, peak_drift_m and ductility: linear between
/// the sorted values, the first at 0 and the last at 1. A stopped run lies above every other, so a fractile that
/// reaches one is empty. With `by`, one such curve for each combination of the values of these columns, which stand
/// first. Throws std::logic_error when `along` is no column of numbers or one of `by` is none.
Table fractiles(const Table &runs, const std::string &along, const std::vector<std::string> &by = {});

} // namespace rimpact::fleets

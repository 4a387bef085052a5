/// A building's summary in one row of a table.
#pragma once
#include "responses/summary.h"

namespace rimpact::buildings {

/// The summary with its `building` spread out among the extras: `worst_bearing` (from 1), `n_bearings_hit`,
/// `peak_overturning_N_m`, `peak_base_rotation_rad`, `peak_base_acceleration_m_s2`, `peak_base_displacement_m`,
/// `peak_uplift_m` (the largest of all bearings), `largest_static_normal_force_N`, and of every floor I
/// `floor_I_peak_drift_m` with `_x_m` and `_y_m`, `floor_I_peak_acceleration_m_s2`, `floor_I_peak_shear_N`.
Summary row_summary(Summary summary);

} // namespace rimpact::buildings

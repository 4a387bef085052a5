/// The building in motion for ParaView: fields/*.vtu, one a stored instant, and fields.pvd over time.
#pragma once
#include "buildings/recorder.h"

namespace rimpact::buildings {

/// Members as lines, bearings as points; nodes at rest with `displacement` [m] to warp by, cells with `axial_kN`,
/// `moment_kN_m` (larger end), `normal_force_kN`, `rim_force_kN` (zero where they mean nothing) and `kind` (0 member,
/// 1 bearing). Throws IoError.
void write_vtk_series(const Frame &frame, const BuildingModel &model, const BuildingTrace &trace,
                      const std::string &folder);
/// elevation.csv: every node at rest, displaced at the hardest instant, and what its bearing carries there.
void write_elevation(const Frame &frame, const BuildingModel &model, const BuildingInstant &hardest,
                     const std::string &path);

} // namespace rimpact::buildings

/// Pictures' data: VTU files of the deformed solids and their PVD index.
#pragma once
#include "fe_contact/drive/run_record.h"
#include "fe_contact/rungs/bearing_model.h"
#include <optional>

namespace rimpact::fe {

/// Writes a state at displacements by dof as fields/RUNG_NNN.vtu and notes it for the PVD. `direction`: of the arc
/// shown [deg].
void write_fields(const BearingSystem &system, const SystemState &state, const Eigen::VectorXd &displacements,
                  double time, const RunOptions &options, RunRecord &record, std::optional<double> direction = {});
/// Whether a step of `dt` that ends at `t` has passed an instant at which an impact's fields are asked for.
bool fields_due(double t, double dt, const RunOptions &options);
void write_pvd(const RunOptions &options, const RunRecord &record);

} // namespace rimpact::fe

/// Pictures' data: VTU files of the deformed solids and their PVD index.
#pragma once
#include "fe_contact/drive/run_record.h"
#include "fe_contact/engine/contact_system.h"
#include <optional>

namespace rimpact::fe {

/// Writes a state at displacements by dof as fields/KIND_NNN.vtu and notes it for the PVD. `direction`: of the arc
/// shown [deg].
void write_fields(const ContactSystem &system, const SystemState &state, const Eigen::VectorXd &displacements,
                  const std::string &kind, double time, const RunOptions &options, RunRecord &record,
                  std::optional<double> direction = {});
/// Whether a step of `dt` that ends at `t` has passed an instant at which an impact's fields are asked for.
bool fields_due(double t, double dt, const RunOptions &options);
void write_pvd(const RunOptions &options, const RunRecord &record);

} // namespace rimpact::fe

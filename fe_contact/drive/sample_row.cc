#include "fe_contact/drive/sample_row.h"

#include "fe_contact/drive/solver_counts.h"

namespace rimpact::fe {

namespace {

/// What was solved since the row before, whether it was taken or not.
void append_work(RunRecord &record) {
  if (record.response.size() == 1) record.rows_work = record.work_so_far(); // what came before the first row is no step
  const SolverWork now = record.work_so_far(), &before = record.rows_work;
  for (const auto &count : solver_counts)
    if (count.signal) record.response.append(count.signal, static_cast<double>(now.*count.of - before.*count.of));
  record.rows_work = now;
}

} // namespace

std::vector<std::pair<const char *, double>> foot_signals(const FootForces &foot) {
  std::vector<std::pair<const char *, double>> values{{"rim_foot_normal", foot.normal},
                                                      {"rim_foot_shear", foot.shear},
                                                      {"rim_foot_moment", foot.moment},
                                                      {"rim_foot_normal_per_length", foot.worst.normal},
                                                      {"rim_foot_shear_per_length", foot.worst.shear},
                                                      {"rim_foot_moment_per_length", foot.worst.moment},
                                                      {"rim_foot_weld_force", foot.weld}};
  if (foot.use) values.emplace_back("rim_foot_use", *foot.use);
  return values;
}

std::vector<std::pair<const char *, double>> energy_signals(const EnergyLedger &e) {
  return {{"energy_external", e.external},    {"energy_gravity", e.gravity}, {"energy_kinetic", e.kinetic},
          {"energy_elastic", e.elastic},      {"energy_plastic", e.plastic}, {"energy_damping", e.damping},
          {"energy_friction", e.friction},    {"energy_impact", e.impact},   {"energy_contact", e.contact},
          {"energy_integrator", e.integrator}};
}

void append(RunRecord &record, const SampleRow &row) {
  auto &r = record.response;
  const char *axes[3] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    r.append(std::string("displacement_") + axes[i], row.u[i]);
    r.append(std::string("velocity_") + axes[i], row.v[i]);
    r.append(std::string("force_") + axes[i], row.total[i]);
    if (i == 2) break;
    r.append(std::string("pendular_") + axes[i], row.pendular[i]);
    r.append(std::string("friction_") + axes[i], row.friction[i]);
    r.append(std::string("impact_") + axes[i], row.impact[i]);
  }
  const std::pair<const char *, double> values[] = {{"time", row.time},
                                                    {"gap", row.gap},
                                                    {"surface_gap", row.surface_gap},
                                                    {"plastic_strain_max", row.plastic_strain},
                                                    {"contact_pressure_max", row.contact_pressure},
                                                    {"newton_iterations", static_cast<double>(row.newton_iterations)},
                                                    {"step", row.step}};
  for (const auto &[name, value] : values) r.append(name, value);
  for (const auto &[name, value] : energy_signals(record.ledger)) r.append(name, value);
  append_work(record);
  if (row.pad_pressure) r.append("pad_pressure_max", *row.pad_pressure);
  if (row.seat) {
    const double so_far = // what the preload took is no part of it
        r.has("energy_friction_seat") ? r.series("energy_friction_seat").back() + row.seat->friction_work : 0.0;
    r.append("energy_friction_seat", so_far);
    r.append("seat_pressure_max", row.seat->bottom);
    r.append("recess_pressure_max", row.seat->wall);
  }
  if (row.foot)
    for (const auto &[name, value] : foot_signals(*row.foot)) r.append(name, value);
  if (row.slip)
    for (int i = 0; i < 2; ++i) r.append(std::string("interface_slip_") + axes[i], (*row.slip)[i]);
  if (row.normal_force) r.append("normal_force", *row.normal_force);
}

} // namespace rimpact::fe

#include "fe_contact/drive/forces.h"

#include "fe_contact/drive/sample_row.h"
#include "fe_contact/drive/steel_places.h"
#include "fe_contact/engine/solid_fields.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::fe {

BearingForces forces_of(const BearingSystem &system, const SystemState &state) {
  BearingForces result;
  result.rim = system.force_of(state, Role::wall);
  for (const Role role : {Role::dish, Role::edge}) {
    if (!system.contact_of(role)) continue;
    const Eigen::Vector3d force = system.force_of(state, role), friction = system.friction_of(state, role);
    result.friction += friction;
    result.pendular += force - friction;
    result.normal = result.normal.value_or(0) + force.z();
  }
  return result;
}

SteelReport steel_of(const BearingModel &model, const SystemState &state, const std::optional<RimFrame> &frame) {
  if (state.history.empty()) return {}; // nothing began
  SteelReport report = steel_by_place(model.space, model.bearing, state.history);
  if (frame)
    for (auto &[place, at] : report) at.place = frame->in_plate(at.place);
  return report;
}

std::optional<std::string> stop_of_halves(const BearingSystem &system, const SystemState &state,
                                          const std::string &where) {
  const scene::UpperSlider &slider = system.model().bearing.slider;
  const double slip = system.interface_slip(state.u).head<2>().norm(); // halves may part, too
  if (slip <= slider.interface_gap) return {};
  return fmt::format("at {} the halves of the slider have slipped {:.2f} mm, to their stop (slider.interface_gap_mm "
                     "{:g}), which finite elements do not have: nothing beyond is a result; `rimpact reduced` with "
                     "reduced.model \"lir-dcfp\" has it",
                     where, 1e3 * slip, 1e3 * slider.interface_gap);
}

namespace {

std::optional<Eigen::Vector2d> slip_of(const BearingSystem &system, const SystemState &state) {
  if (!system.model().slips()) return {};
  return system.interface_slip(state.u).head<2>();
}

/// Nothing while the rim stands still.
std::optional<FootForces> foot_of(const BearingSystem &system, const SystemState &state) {
  const BearingModel &model = system.model();
  if (!model.foot.exists()) return {};
  if (system.contact_of(Role::wall)) return model.foot.of(system.expand(state), state.history);
  return FootForces::none(model.bearing);
}

std::optional<SampleRow::Seat> seat_of(const BearingSystem &system, const SystemState &state) {
  const auto *bottom = system.report_of(state, Role::seat), *wall = system.report_of(state, Role::recess);
  if (!bottom || !wall) return {};
  return SampleRow::Seat{bottom->largest_pressure, wall->largest_pressure,
                         system.model().energy_share() * (bottom->friction_work + wall->friction_work)};
}

} // namespace

void sample(RunRecord &record, const BearingSystem &system, const SystemState &state, const Instant &now) {
  double pressure = 0;
  for (const auto &report : state.reports) pressure = std::max(pressure, report.largest_pressure);
  std::optional<double> pad_pressure;
  if (const auto *dish = system.report_of(state, Role::dish)) pad_pressure = dish->largest_pressure;
  append(record, {now.time, now.u, now.v, now.forces.total(), now.forces.pendular, now.forces.friction, now.forces.rim,
                  now.forces.normal, now.gap, system.wall_distance(state, now.gap),
                  largest_plastic_strain(state.history), pressure, now.newton_iterations, now.step, pad_pressure,
                  seat_of(system, state), foot_of(system, state), slip_of(system, state)});
}

} // namespace rimpact::fe

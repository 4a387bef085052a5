#include "reduced_models/record/building_recorder.h"
#include <fmt/format.h>

namespace rimpact::reduced {

BuildingSnapshot snapshot(const Superstructure &building, const FloorMotion &base, const FloorMotion *floors,
                          const Eigen::Vector2d *z) {
  BuildingSnapshot s;
  const int n = building.n_floors();
  const FloorMotion *below = &base;
  for (int i = 0; i < n; ++i) {
    const Storey &storey = building.storeys[i];
    const Eigen::Vector3d drift = floors[i].position - below->position;
    const Eigen::Vector3d force = storey.force(drift, floors[i].velocity - below->velocity, z[i]);
    s.drift[i] = drift.head<2>(), s.shear[i] = force.head<2>();
    s.acceleration[i] = force / storey.mass;
    if (i > 0) s.acceleration[i - 1] -= force / building.storeys[i - 1].mass;
    below = floors + i;
  }
  s.roof = floors[n - 1].position - base.position;
  return s;
}

BuildingSnapshot snapshot(const Superstructure &building, const State &y, const FloorMotion &base) {
  std::array<FloorMotion, max_floors> floors;
  std::array<Eigen::Vector2d, max_floors> z;
  for (int i = 0; i < building.n_floors(); ++i)
    floors[i] = building.floor(y, i), z[i] = Superstructure::hysteresis(y, i);
  return snapshot(building, base, floors.data(), z.data());
}

void BuildingRecorder::watch(const BuildingSnapshot &now) {
  for (int i = 0; i < building_.n_floors(); ++i) {
    drift_[i] = std::max(drift_[i], now.drift[i].norm());
    shear_[i] = std::max(shear_[i], now.shear[i].norm());
    acceleration_[i] = std::max(acceleration_[i], now.acceleration[i].head<2>().norm());
  }
}

const std::vector<std::string> &BuildingRecorder::signals() {
  static const std::vector<std::string> names{
      "drift_x", "drift_y", "storey_shear_x",      "storey_shear_y",      "roof_x",
      "roof_y",  "roof_z",  "roof_acceleration_x", "roof_acceleration_y", "roof_acceleration_z"};
  return names;
}

void BuildingRecorder::append(const BuildingSnapshot &now, int n_floors, Response &response) {
  const auto &top = now.acceleration[n_floors - 1];
  const double row[] = {now.drift[0][0], now.drift[0][1], -now.shear[0][0], -now.shear[0][1], now.roof[0],
                        now.roof[1],     now.roof[2],     top[0],           top[1],           top[2]};
  for (std::size_t i = 0; i < std::size(row); ++i) response.append(signals()[i], row[i]);
}

void BuildingRecorder::summarise(const BuildingSnapshot &last, std::optional<double> collapse_time,
                                 Summary &summary) const {
  auto &extra = summary.extra;
  double drift = 0, shear = 0, acceleration = 0;
  nlohmann::json storeys = nlohmann::json::array();
  for (int i = 0; i < building_.n_floors(); ++i) {
    drift = std::max(drift, drift_[i]), shear = std::max(shear, shear_[i]);
    acceleration = std::max(acceleration, acceleration_[i]);
    storeys.push_back({{"peak_drift_m", drift_[i]},
                       {"residual_drift_m", last.drift[i].norm()},
                       {"peak_shear_N", shear_[i]},
                       {"peak_acceleration_m_s2", acceleration_[i]}});
  }
  extra["peak_drift_m"] = drift;
  extra["peak_storey_shear_N"] = shear;
  extra["peak_floor_acceleration_m_s2"] = acceleration;
  if (const auto &law = building_.storeys[0].hysteresis) {
    extra["ductility"] = drift / law->yield;
    extra["collapsed"] = collapse_time.has_value();
  }
  extra["superstructure"] = {{"storeys", storeys}};
  if (!collapse_time) return;
  summary.status = RunStatus::stopped;
  summary.reason = fmt::format("the superstructure collapsed at t = {:.6g} s: its drift reached {:.6g} m, where "
                               "softening leaves it no strength",
                               *collapse_time, building_.collapse_drift);
}

} // namespace rimpact::reduced

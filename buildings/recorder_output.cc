// What a building's recorder stores and says.
#include "buildings/recorder.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::buildings {

using Eigen::Vector2d, Eigen::Vector3d, Eigen::VectorXd;

namespace {

/// One row of a response, signal by signal.
struct Row {
  Response &response;
  void put(const std::string &name, double value) { response.append(name, value); }
  template <class V> void plane(const std::string &name, const V &v) { put(name + "_x", v[0]), put(name + "_y", v[1]); }

  void whole(const BuildingBasis &d, const VectorXd &y, const BuildingResponse &r);
  void bearing(int number, const BearingResponse &one, bool rigid_bodies);
  void energies(const EnergyLedger &l, bool plastic);
  void hinges(const BuildingResponse &r);
};

void Row::whole(const BuildingBasis &d, const VectorXd &y, const BuildingResponse &r) {
  Vector3d pendular = Vector3d::Zero(), friction = pendular, impact = pendular;
  double normal = 0, gap = 1e300, z = 0, vz = 0;
  for (const auto &b : r.bearings) {
    pendular += b.pendular, friction += b.friction, impact += b.impact;
    normal += std::max(0.0, b.normal), gap = std::min(gap, b.gap);
    z += b.u[2] / d.n_bearings(), vz += b.v[2] / d.n_bearings();
  }
  const Vector3d force = pendular + friction + impact;
  plane("displacement", y.head<2>()), put("displacement_z", z);
  plane("velocity", y.segment<2>(d.n)), put("velocity_z", vz);
  plane("force", force), put("force_z", force[2]);
  plane("pendular", pendular), plane("friction", friction), plane("impact", impact);
  plane("ground_acceleration", r.ground), put("ground_acceleration_z", r.ground[2]);
  put("gap", gap), put("normal_force", normal), put("base_rotation", y[2]);
  plane("base_acceleration", Vector2d(r.acceleration.head<2>() + r.ground.head<2>()));
}

void Row::bearing(int number, const BearingResponse &one, bool rigid_bodies) {
  const std::string name = fmt::format("bearing_{}_", number);
  plane(name + "displacement", one.u), put(name + "displacement_z", one.u[2]);
  plane(name + "force", one.force()), plane(name + "impact", one.impact);
  put(name + "normal_force", std::max(0.0, one.normal)), put(name + "gap", one.gap);
  if (rigid_bodies) plane(name + "interface_slip", one.interface_slip), plane(name + "moment", one.moment);
}

void Row::energies(const EnergyLedger &l, bool plastic) {
  put("energy_external", l.external), put("energy_gravity", l.gravity), put("energy_kinetic", l.kinetic);
  put("energy_elastic", l.elastic), put("energy_damping", l.damping), put("energy_friction", l.friction);
  put("energy_impact", l.impact), put("energy_contact", l.contact);
  if (plastic) put("energy_plastic", l.plastic);
}

void Row::hinges(const BuildingResponse &r) {
  for (std::size_t i = 0; i < r.members.hinges.size(); ++i) {
    const char end = i % 2 ? 'j' : 'i';
    put(fmt::format("member_{}_moment_{}", i / 2 + 1, end), r.members.hinges[i].moment);
    put(fmt::format("member_{}_rotation_{}", i / 2 + 1, end), r.members.hinges[i].plastic_rotation);
  }
}

} // namespace

void BuildingRecorder::store(double t, const VectorXd &y, const BuildingResponse &r) {
  if (!response_ || t < last_sample_ + 5e-7) return;
  last_sample_ = t;
  Row row{*response_};
  row.put("time", t);
  row.whole(dynamics_, y, r);
  row.plane("overturning", overturning(r));
  row.energies(ledger(y), !r.members.hinges.empty());
  for (int b = 0; b < dynamics_.n_bearings(); ++b) row.bearing(b + 1, r.bearings[b], dynamics_.rigid_bodies);
  row.hinges(r);
  for (int f = 0; f < static_cast<int>(floors_.size()); ++f) {
    const int dof = 3 * (f + 1);
    const std::string name = fmt::format("floor_{}_", f + 1);
    row.plane(name + "displacement", y.segment<2>(dof)), row.put(name + "rotation", y[dof + 2]);
    row.plane(name + "drift", drift(f, y));
    row.plane(name + "acceleration", Vector2d(r.acceleration.segment<2>(dof) + r.ground.head<2>()));
  }
}

nlohmann::json BuildingRecorder::table_of(std::size_t b, double residual) const {
  const auto &p = bearings_[b];
  nlohmann::json table{{"x_m", dynamics_.slider[b].arm_x},
                       {"y_m", dynamics_.slider[b].arm_y},
                       {"static_normal_force_N", dynamics_.reactions[b]},
                       {"peak_displacement_m", p.travel},
                       {"peak_force_N", p.force},
                       {"peak_impact_force_N", p.impact},
                       {"impacts", p.impacts.size()},
                       {"max_normal_force_N", p.largest_normal},
                       {"min_normal_force_N", p.smallest_normal},
                       {"peak_uplift_m", p.lift},
                       {"residual_displacement_m", residual}};
  if (!p.impacts.empty()) table["first_touch_s"] = p.impacts[0].touch_time;
  if (p.interface_slip == Vector2d::Zero()) return table;
  table["residual_interface_slip_x_m"] = p.interface_slip[0];
  table["residual_interface_slip_y_m"] = p.interface_slip[1];
  return table;
}

void BuildingRecorder::summarise(Summary &s) const {
  s.peak_displacement = 0, s.peak_lateral_force = peak_shear_, s.peak_vertical_displacement = peak_height_;
  s.min_normal_force = smallest_total_, s.residual_displacement = 0, s.final_speed = 0;
  s.n_steps = steps.n();
  s.peak_impact_force = 0;
  nlohmann::json bearings = nlohmann::json::array(), floors = nlohmann::json::array();
  std::size_t worst = 0;
  const auto rank = [&](std::size_t b) {
    return std::pair(bearings_[b].impact, bearings_[b].travel / dynamics_.capacity[b]);
  };
  for (std::size_t b = 0; b < bearings_.size(); ++b) {
    const auto &p = bearings_[b];
    const auto &node = dynamics_.slider[b];
    if (rank(b) > rank(worst)) worst = b;
    s.peak_displacement = std::max(s.peak_displacement, p.travel),
    *s.peak_impact_force = std::max(*s.peak_impact_force, p.impact);
    const double residual = node.of(final_.data()).head<2>().norm();
    s.residual_displacement = std::max(s.residual_displacement, residual);
    s.final_speed = std::max(*s.final_speed, node.of(final_.data() + dynamics_.n).head<2>().norm());
    s.impacts.insert(s.impacts.end(), p.impacts.begin(), p.impacts.end());
    bearings.push_back(table_of(b, residual));
  }
  std::stable_sort(s.impacts.begin(), s.impacts.end(),
                   [](const auto &a, const auto &b) { return a.touch_time < b.touch_time; });
  for (const auto &f : floors_)
    floors.push_back({{"peak_displacement_m", f.displacement},
                      {"peak_drift_m", f.drift},
                      {"peak_drift_x_m", f.drift_x},
                      {"peak_drift_y_m", f.drift_y},
                      {"peak_acceleration_m_s2", f.acceleration},
                      {"peak_shear_N", f.shear}});
  s.energy = ledger(final_);
  s.extra["building"] = {{"bearings", bearings},
                         {"floors", floors},
                         {"worst_bearing", worst + 1},
                         {"peak_base_shear_N", peak_shear_},
                         {"peak_overturning_N_m", peak_overturning_},
                         {"peak_base_rotation_rad", peak_rotation_},
                         {"peak_base_acceleration_m_s2", base_acceleration_},
                         {"weight_N", dynamics_.weight},
                         {"peak_base_displacement_m", peak_displacement_}};
}

} // namespace rimpact::buildings

#include "reduced_models/rigid_body/bearing_recorder.h"
#include "reduced_models/simulate.h"
#include "scene/size_limits.h"
#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <fmt/format.h>

namespace rimpact::reduced::rigid {

using Eigen::Vector3d;

namespace {

/// Shares of the force of the bearing on the top plate.
struct PlateForces {
  Vector3d pendular = Vector3d::Zero(), friction = Vector3d::Zero(), impact = Vector3d::Zero();
  double normal = 0;
  Vector3d moment = Vector3d::Zero(); ///< about the plate's vertex
};

PlateForces on_plate(const RigidBearing &model, const MotionState &s) {
  PlateForces p;
  for (std::size_t i = 0; i < s.contact.size(); ++i) {
    const auto &c = model.system.contacts[i];
    if (c.master != model.plate) continue;
    (c.surface == Surface::rim ? p.impact : p.pendular) -= s.contact[i].normal;
    p.friction -= s.contact[i].friction;
    p.moment -= (s.contact[i].at - s.poses[model.plate].position).cross(s.contact[i].normal + s.contact[i].friction);
    if (c.surface == Surface::dish) p.normal += s.contact[i].size;
  }
  return p;
}

/// Signal of every contact point, normal_B1, ...; empty for rims and stops.
std::vector<std::string> point_names(const RigidBearing &model) {
  std::vector<std::string> names;
  int index[max_sets] = {};
  for (const auto &c : model.system.contacts)
    names.push_back(is_wall(c.surface) ? ""
                                       : fmt::format("normal_{}{}", model.parts.joints[c.set].name, ++index[c.set]));
  return names;
}

/// Signals of the steel of each joint, from the ground up.
std::vector<std::string> temperature_names(const RigidBearing &model) {
  if (model.triple()) return {"temperature", "temperature_inner", "temperature_inner_top", "temperature_top"};
  std::vector<std::string> names(model.parts.joints.size());
  names.front() = "temperature", names.back() = "temperature_top";
  return names;
}

bool rim_pressed(const RigidBearing &model, const MotionState &s) {
  for (std::size_t i = 0; i < s.contact.size(); ++i)
    if (model.system.contacts[i].surface == Surface::rim && s.contact[i].size != 0) return true;
  return false;
}

} // namespace

BearingRecorder::BearingRecorder(RigidBearing &model, const scene::Scene &scene, double time_unit, ReducedRun &result)
    : model_(model), result_(result), ground_(scene.excitation, scene.load.gravity), time_unit_(time_unit),
      sample_(model.driven ? time_unit / (scene::instants_a_cycle * scene.excitation.whole_rounds())
                           : scene.reduced.output_step),
      points_(point_names(model)), temperatures_(temperature_names(model)),
      largest_normal_(model.system.contacts.size(), 0), smallest_normal_(model.system.contacts.size(), 1e300),
      faces_(model), heat_(scene, model.parts, model.system), heats_(scene.reduced.measured.by_temperature),
      building_(model.building) {
  result.summary.n_dofs = std::count(model.system.free.begin(), model.system.free.end(), true);
}

void BearingRecorder::begin(const MotionState &s) {
  potential_ = model_.potential_energy(s), stored_ = model_.stored_energy(s);
  rest_height_ = model_.plate_displacement(model_.state_at({0, 0}, {0, 0}))[2];
  initial_ = model_.system.kinetic_energy(s.poses, s.velocity);
  const MotionState rest = model_.state_at({0, 0}, {0, 0});
  const double height = potential_ - model_.potential_energy(rest);
  initial_ += height, potential_ -= height; // let go from a height: part of what it starts with
  watch(s);
  store(s);
}

void BearingRecorder::count(const StepReport &report) {
  steps_.add(result_.response.size() ? result_.response.series("time").back() : 0);
  result_.summary.n_newton_iterations += report.iterations;
}

double BearingRecorder::next_sample(const MotionState &s) const {
  return (std::floor(s.t / sample_ + 1e-9) + 1) * sample_;
}

void BearingRecorder::accept(const MotionState &s, const MotionState &before) {
  watch(s);
  walls_.press(model_.system, s);
  heat_.pass(model_.system, s, s.t);
  const bool due = std::abs(s.t / sample_ - std::round(s.t / sample_)) < 1e-9;
  if (due || rim_pressed(model_, s) || rim_pressed(model_, before)) store(s);
}

void BearingRecorder::watch(const MotionState &s) {
  largest_input_ = std::max(largest_input_, std::abs(s.works.external));
  for (std::size_t i = 0; i < s.contact.size(); ++i) {
    largest_normal_[i] = std::max(largest_normal_[i], s.contact[i].size);
    smallest_normal_[i] = std::min(smallest_normal_[i], s.contact[i].size);
  }
  if (model_.triple()) faces_.watch(s);
  const auto p = on_plate(model_, s);
  largest_moment_ = std::max(largest_moment_, p.moment.head<2>().norm());
  const Vector3d u = model_.plate_displacement(s);
  largest_travel_ = std::max(largest_travel_, u.head<2>().norm());
  largest_lateral_ = std::max(largest_lateral_, (p.pendular + p.friction + p.impact).head<2>().norm());
  largest_height_ = std::max(largest_height_, u[2] - rest_height_);
  smallest_on_plate_ = std::min(smallest_on_plate_, p.normal);
  const double vertical = (p.pendular + p.friction)[2];
  largest_vertical_ = std::max(largest_vertical_, vertical);
  smallest_vertical_ = std::min(smallest_vertical_, vertical);
  if (!model_.building.any()) return;
  const auto building = model_.building_at(s);
  building_.watch(building);
  for (int i = 0; i < model_.building.n_floors(); ++i)
    if (building.drift[i].norm() >= model_.building.collapse_drift) collapse_time_ = s.t;
}

EnergyLedger BearingRecorder::ledger(const MotionState &s) const {
  EnergyLedger l;
  l.initial = initial_;
  l.external = s.works.external;
  l.gravity = model_.potential_energy(s) - potential_;
  l.kinetic = model_.system.kinetic_energy(s.poses, s.velocity);
  l.friction = s.works.slip, l.impact = s.works.wall, l.contact = s.works.normal;
  l.damping = s.works.damping, l.plastic = s.works.hysteretic;
  for (const auto &link : s.link) l.elastic += link.elastic_energy, l.plastic -= link.hysteretic_energy;
  l.largest_input = largest_input_ + initial_;
  return l;
}

void BearingRecorder::store(const MotionState &s) {
  if (s.t <= last_) return;
  last_ = s.t;
  const auto p = on_plate(model_, s);
  const Vector3d u = model_.plate_displacement(s), v = s.velocity.segment<3>(6 * model_.plate);
  const Vector3d force = p.pendular + p.friction + p.impact, slip = model_.interface_slip(s);
  const auto l = ledger(s);
  const std::pair<const char *, double> row[] = {{"time", s.t / time_unit_},
                                                 {"displacement_x", u[0]},
                                                 {"displacement_y", u[1]},
                                                 {"displacement_z", u[2] - rest_height_},
                                                 {"velocity_x", model_.driven ? 0 : v[0]},
                                                 {"velocity_y", model_.driven ? 0 : v[1]},
                                                 {"velocity_z", model_.driven ? 0 : v[2]},
                                                 {"force_x", force[0]},
                                                 {"force_y", force[1]},
                                                 {"force_z", force[2]},
                                                 {"pendular_x", p.pendular[0]},
                                                 {"pendular_y", p.pendular[1]},
                                                 {"friction_x", p.friction[0]},
                                                 {"friction_y", p.friction[1]},
                                                 {"impact_x", p.impact[0]},
                                                 {"impact_y", p.impact[1]},
                                                 {"gap", model_.gap(s)},
                                                 {"normal_force", p.normal},
                                                 {"tilt", model_.tilt(s)},
                                                 {"interface_slip_x", slip[0]},
                                                 {"interface_slip_y", slip[1]},
                                                 {"energy_external", l.external},
                                                 {"energy_gravity", l.gravity},
                                                 {"energy_kinetic", l.kinetic},
                                                 {"energy_friction", l.friction},
                                                 {"energy_impact", l.impact},
                                                 {"energy_contact", l.contact}};
  std::size_t column = 0;
  const auto put = [&](const auto &name, double value) { // names are looked up once
    if (column == columns_.size()) columns_.push_back(&result_.response.series(name));
    columns_[column++]->push_back(value);
  };
  for (const auto &[name, value] : row) put(name, value);
  for (std::size_t i = 0; i < s.contact.size(); ++i)
    if (!points_[i].empty()) put(points_[i], s.contact[i].size);
  for (std::size_t j = 0; j < temperatures_.size(); ++j)
    if (heats_ && !temperatures_[j].empty()) put(temperatures_[j], model_.system.temperature[j]);
  if (model_.triple()) faces_.store(s, put);
  put("plate_moment_x", p.moment[0]), put("plate_moment_y", p.moment[1]);
  if (!model_.driven) {
    const Vector3d ground = ground_.acceleration(s.t), plate = s.acceleration.segment<3>(6 * model_.plate) + ground;
    put("ground_acceleration_x", ground[0]), put("ground_acceleration_y", ground[1]);
    put("ground_acceleration_z", ground[2]);
    put("acceleration_x", plate[0]), put("acceleration_y", plate[1]), put("acceleration_z", plate[2]);
  }
  if (!model_.building.any()) return;
  put("energy_elastic", l.elastic), put("energy_plastic", l.plastic), put("energy_damping", l.damping);
  BuildingRecorder::append(model_.building_at(s), model_.building.n_floors(), result_.response);
}

void BearingRecorder::end(const MotionState &s) {
  store(s);
  auto &summary = result_.summary;
  summarise_response(result_.response, summary);
  if (!model_.driven) add_impulses(result_.response, summary.impacts);
  // Samples may miss these.
  summary.peak_displacement = largest_travel_, summary.peak_lateral_force = largest_lateral_;
  summary.peak_vertical_displacement = largest_height_, summary.min_normal_force = smallest_on_plate_;
  summary.n_steps = steps_.n();
  summary.energy = ledger(s);
  summary.rung = SolvedBy::reduced;
  nlohmann::json points = nlohmann::json::object();
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (!points_[i].empty())
      points[points_[i].substr(7)] = {{"max_N", largest_normal_[i]}, {"min_N", smallest_normal_[i]}};
  summary.extra["isolator"] = {{"point_forces", points},
                               {"max_vertical_force_N", largest_vertical_},
                               {"min_vertical_force_N", smallest_vertical_},
                               {"max_moment_N_m", largest_moment_},
                               {"residual_interface_slip_m", model_.interface_slip(s).norm()}};
  if (model_.triple()) summary.extra["isolator"]["faces"] = faces_.summary();
  if (heats_) summary.extra["friction"] = {{"peak_temperature_C", heat_.warmest()}};
  if (model_.building.any()) building_.summarise(model_.building_at(s), collapse_time_, summary);
}

void BearingRecorder::stop(const MotionState &s, const std::string &reason) {
  end(s);
  result_.summary.status = RunStatus::stopped, result_.summary.reason = reason;
}

} // namespace rimpact::reduced::rigid

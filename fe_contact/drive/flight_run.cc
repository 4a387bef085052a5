#include "fe_contact/drive/flight_run.h"
#include "fe_contact/drive/fields.h"
#include "fe_contact/drive/forces.h"
#include "fe_contact/drive/record_checkpoint.h"
#include "fe_contact/drive/sample_row.h"
#include "fe_contact/drive/solver_counts.h"
#include "fe_contact/drive/state_fields.h"
#include "fe_contact/engine/solid_fields.h"

#include "io/files/error.h"
#include <algorithm>
#include <cmath>

namespace rimpact::fe {
namespace {

/// Arcs closer than this share one yielded state [rad].
constexpr double arc_width = 0.14;
constexpr double shortest_stretch = 1e-12; ///< less than this before its end a scene has ended [s]
constexpr double nearest_look = 1e-3;      ///< a dented arc's true gap is computed within this of touch [m]
constexpr int steps_a_checkpoint = 25;     ///< in contact

void visit_bearing(StateVisitor &v, reduced::BearingState &bearing, double end) {
  constexpr Limits reach{-1e4, 1e4};
  v.number("time", bearing.t, {0, end + 1e-9});
  v.point("u", bearing.u, reach);
  v.point("v", bearing.v, reach);
  v.flag("airborne", bearing.airborne);
  v.number("eta_x", bearing.eta.x(), reach);
  v.number("eta_y", bearing.eta.y(), reach);
}

} // namespace

FlightRun::FlightRun(const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options,
                     BearingSystem &system, RunRecord &record)
    : Drive(options, record, steps_a_checkpoint), scene_(scene), plan_(plan), system_(system),
      step_options_(step_options(system.model().rung, scene, plan)), model_(scene), loads_(scene, model_),
      bearing_(model_.initial_state()), support_(loads_.initial_support()),
      touch_height_(model_.height(scene.bearing.lateral_capacity(), 0).z) {}

void FlightRun::run() {
  if (options_.resume)
    restore(kept_checkpoint(options_, record_));
  else
    start();
  if (record_.ended) return;
  while (bearing_.t < end_time() - shortest_stretch) {
    if (!in_contact_ && !fly()) return finish();
    contact();
    if (window() && !in_contact_) return finish();
  }
  finish();
}

void FlightRun::start() {
  record_.ledger.initial = 0.5 * scene_.load.mass * bearing_.v.squaredNorm();
  record_.ledger.largest_input = record_.ledger.initial;
  record_.ledger.kinetic = record_.ledger.initial;
}

double FlightRun::wall_gap(const Eigen::Vector3d &u) const {
  const double plain = capacity() - u.head<2>().norm();
  if (plain > nearest_look) return plain;
  const Arc *arc = arc_at(u);
  return arc && arc->yielded ? arc->frame.rate_ratio() * system_.wall_gap(arc->state, arc->frame.master(u)) : plain;
}

const Arc *FlightRun::arc_at(const Eigen::Vector3d &u) const {
  const double direction = std::atan2(u.y(), u.x());
  for (const auto &arc : arcs_)
    if (std::abs(std::remainder(direction - arc.frame.direction, 2 * M_PI)) < arc_width) return &arc;
  return nullptr;
}

void FlightRun::choose_arc() {
  if (const Arc *known = arc_at(bearing_.u)) {
    current_ = static_cast<std::size_t>(known - arcs_.data());
    return;
  }
  const double direction = std::atan2(bearing_.u.y(), bearing_.u.x());
  for (const auto &arc : arcs_)
    if (std::abs(std::remainder(direction - arc.frame.direction, 2 * M_PI)) < 3 * arc_width)
      record_.warnings.push_back("two touched arcs lie within " + std::to_string(int(3 * arc_width * 180 / M_PI)) +
                                 " degrees of one another; each was solved with its own yielded state");
  arcs_.push_back({frame_at(direction), system_.at_rest(), false});
  current_ = arcs_.size() - 1;
}

bool FlightRun::fly() {
  if (window() && bearing_.t == 0) return true; // a window starts at touch
  const auto stop = [this](const Eigen::Vector3d &u) { return wall_gap(u); };
  const double chunk = 0.25; // for progress and Ctrl-C [s]
  while (bearing_.t < end_time()) {
    if (is_interrupted(options_)) throw Interrupted();
    EnergyLedger before = record_.ledger;
    const auto end = reduced_flight(std::min(end_time(), bearing_.t + chunk), stop);
    bearing_ = end.state;
    record_.ledger.elastic = before.elastic; // what the arcs keep
    record_.ledger.plastic = before.plastic;
    if (options_.progress)
      options_.progress({bearing_.t, end_time(), chunk, 0, wall_gap(bearing_.u), 0.0, Phase::flight});
    if (end.stopped) return true;
  }
  return false;
}

reduced::FlightEnd FlightRun::reduced_flight(double t_end, const std::function<double(const Eigen::Vector3d &)> &stop) {
  try {
    const auto end = model_.fly(bearing_, t_end, stop, record_.response, record_.ledger);
    pad_fe_signals();
    return end;
  } catch (const SolverStopped &) {
    pad_fe_signals(); // what is before the stop is kept
    throw;
  }
}

void FlightRun::pad_fe_signals() {
  double strain = 0;
  for (const auto &arc : arcs_) strain = std::max(strain, largest_plastic_strain(arc.state.history));
  auto &r = record_.response;
  auto values = energy_signals(record_.ledger);
  values.insert(values.end(), {{"plastic_strain_max", strain}, {"contact_pressure_max", 0}, {"newton_iterations", 0}});
  for (const auto &[name, value] : values) r.series(name).resize(r.size(), value);
  if (system_.model().foot.exists())
    for (const auto &[name, value] : foot_signals(FootForces::none(scene_.bearing)))
      r.series(name).resize(r.size(), value);
  for (const auto &count : solver_counts)
    if (count.signal) r.series(count.signal).resize(r.size(), 0.0);
  auto &gap = r.series("surface_gap");
  auto &step = r.series("step");
  for (std::size_t k = gap.size(); k < r.size(); ++k) gap.push_back(r.series("gap")[k]);
  for (std::size_t k = step.size(); k < r.size(); ++k)
    step.push_back(k > 0 ? r.series("time")[k] - r.series("time")[k - 1] : 0.0);
}

void FlightRun::sample(int iterations, const MassForces &forces, double dt) {
  const Eigen::Vector3d rim = rim_force();
  fe::sample(record_, system_, arc().state,
             {bearing_.t, bearing_.u, bearing_.v,
              BearingForces{forces.pendular, forces.friction, rim, std::max(0.0, forces.normal)}, -penetration(),
              iterations, dt});
}

void FlightRun::write_fields() {
  fe::write_fields(system_, arc().state, system_.expand(arc().state), bearing_.t, options_, record_,
                   arc().frame.direction * 180 / M_PI);
}

SteelReport FlightRun::steel() const {
  SteelReport worst;
  for (const Arc &arc : arcs_) keep_worst(worst, steel_of(system_.model(), arc.state, arc.frame));
  return worst;
}

void FlightRun::finish() {
  if (in_contact_) write_fields();
  if (in_contact_ && impact_.touched()) {
    impact_.set_rebound(-radial_speed()); // the scene's end, not the rim's
    record_.impacts.push_back(impact_.impact());
  }
  record_.ended = true;
  save();
}

void FlightRun::start_afresh() {
  if (!arcs_.empty()) system_.start_afresh_at(arc().state);
}

void FlightRun::visit(StateVisitor &v) {
  constexpr double most_arcs = 1000;
  v.part("bearing", [&] { visit_bearing(v, bearing_, end_time()); });
  v.choice("support", support_);
  v.length("arcs", arcs_, most_arcs, [&] { return Arc{frame_at(0), system_.at_rest(), false}; });
  for (std::size_t k = 0; k < arcs_.size(); ++k)
    v.part("arc" + std::to_string(k), [&, &arc = arcs_[k]] {
      v.number("direction", arc.frame.direction, {-7, 7});
      v.flag("yielded", arc.yielded);
      fe::visit(v, arc.state);
    });
  v.integer("current_arc", current_, 0, std::max(0.0, static_cast<double>(arcs_.size()) - 1));
  v.flag("in_contact", in_contact_);
  v.number("next_step", next_step_, {in_contact_ ? 1e-300 : 0, 1e6});
  v.number("multiplier", multiplier_);
  v.number("others_elastic", others_elastic_);
  v.number("others_plastic", others_plastic_);
  v.number("lift_height", lift_height_);
  v.part("impact", [&] { impact_.visit(v); });
}

void run_flights(const Rung &rung, const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options,
                 RunRecord &record) {
  const BearingModel model(rung, scene.bearing, mesh_order(scene, plan), model_options(scene));
  BearingSystem system(model, scene.load.mass);
  record.n_dofs = system.equations().n;
  FlightRun flight(scene, plan, options, system, record);
  run_counted(
      record, [&] { flight.run(); }, [&] { return system.time_split; }, [&] { return system.work; },
      [&] { return flight.steel(); });
}

} // namespace rimpact::fe

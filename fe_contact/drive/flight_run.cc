#include "fe_contact/drive/flight_run.h"
#include "fe_contact/drive/fields.h"
#include "fe_contact/drive/record_checkpoint.h"
#include "fe_contact/drive/sample_row.h"
#include "fe_contact/drive/solver_counts.h"

#include "io/files/error.h"
#include "responses/open_impact.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::fe {
namespace {

constexpr double shortest_stretch = 1e-12; ///< less than this before its end a scene has ended [s]

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
    : Drive(options, record), scene_(scene), plan_(plan), system_(system), model_(scene),
      bearing_(model_.initial_state()), arcs_(system, model_.height(scene.bearing.lateral_capacity(), 0).z,
                                              MassLoads(scene, model_).initial_support() == Support::held),
      contact_(scene, plan, system, arcs_, model_) {}

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

bool FlightRun::fly() {
  if (window() && bearing_.t == 0) return true; // a window starts at touch
  const auto stop = [this](const Eigen::Vector3d &u) { return arcs_.wall_gap(u); };
  const double chunk = 0.25; // for progress and Ctrl-C [s]
  while (bearing_.t < end_time()) {
    if (is_interrupted(options_)) throw Interrupted();
    EnergyLedger before = record_.ledger;
    const auto end = reduced_flight(std::min(end_time(), bearing_.t + chunk), stop);
    bearing_ = end.state;
    record_.ledger.elastic = before.elastic; // what the arcs keep
    record_.ledger.plastic = before.plastic;
    if (options_.progress)
      options_.progress({bearing_.t, end_time(), chunk, 0, arcs_.wall_gap(bearing_.u), 0.0, Phase::flight});
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
  auto &r = record_.response;
  auto values = energy_signals(record_.ledger);
  values.insert(
      values.end(),
      {{"plastic_strain_max", arcs_.largest_plastic_strain()}, {"contact_pressure_max", 0}, {"newton_iterations", 0}});
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
  fe::sample(record_, system_, arcs_.current().state,
             {bearing_.t, bearing_.u, bearing_.v,
              BearingForces{forces.pendular, forces.friction, contact_.rim_force(), std::max(0.0, forces.normal)},
              -penetration(), iterations, dt});
}

void FlightRun::write_fields() {
  const Arc &arc = arcs_.current();
  fe::write_fields(system_, arc.state, system_.expand(arc.state), bearing_.t, options_, record_,
                   arc.frame.direction * 180 / M_PI);
}

void FlightRun::begin_contact() {
  const MassForces now = contact_.begin(bearing_, record_.ledger);
  const double approach_speed = radial_speed();
  impact_.begin(bearing_.t, bearing_.u, approach_speed);
  next_step_ = contact_.first_step(approach_speed);
  in_contact_ = true;
  if (record_.response.size() == 0) sample(0, now, 0); // a window starts here
}

void FlightRun::contact() {
  if (!in_contact_) {
    if (const auto near = arcs_.choose(bearing_.u)) record_.warnings.push_back(*near);
    begin_contact();
  }
  const double longest = plan_.step_in_contact, smallest = contact_.smallest_step();
  const MarchReport report = stretch_to(bearing_.t, end_time(), {next_step_, smallest, longest});
  if (report.finished) return;
  next_step_ = smallest;
  save();
  throw SolverStopped(fmt::format(
      "the solver stopped at t = {:.6f} s, in contact, with a step of {:.3g} us: {}; partial results are kept; try "
      "--set model.mesh=2 or a smaller model.step_ms and --resume",
      report.reached, 1e6 * smallest, report.reason));
}

double FlightRun::sharp_step(const std::vector<Event> &events) const {
  const bool any = std::ranges::any_of(events, [](Event event) { return event != Event::miss; });
  return any ? contact_.finest_step() : 0;
}

void FlightRun::follow(const SolvedStep &step) {
  bearing_.t = step.end();
  contact_.follow(step);
  book(record_.ledger, contact_.energies());
  bearing_.u = contact_.displacement();
  bearing_.v = contact_.speed();
  sample(step.report.iterations, contact_.forces(), step.dt);
  const double force = contact_.rim_force().head<2>().norm();
  impact_.follow(bearing_.t, force, penetration(), contact_.outward_speed());
  picture(bearing_.t, step.dt);
  if (options_.progress)
    options_.progress({bearing_.t, end_time(), step.dt, step.report.iterations, -penetration(), force, Phase::contact});
  if (contact_.walls_touch()) impact_.touch();
  refuse_passage();
  if (const auto sentence = impact_.touched() ? loss_of_balance(record_.ledger, bearing_.t) : std::nullopt)
    stop_impact(*sentence);
}

void FlightRun::picture(double t, double dt) {
  if (impact_.turns(contact_.outward_speed()) || (impact_.touched() && fields_due(t, dt, options_))) write_fields();
}

bool FlightRun::take(const std::vector<Event> &events) {
  bool ended = false;
  for (const Event event : events) {
    if (event == Event::lift_off) {
      contact_.lift_off();
    } else if (event == Event::landing) {
      contact_.land(record_.ledger);
      bearing_.v = contact_.speed();
    } else {
      end_contact();
      ended = true;
    }
  }
  return ended;
}

void FlightRun::refuse_passage() {
  const Passage passage{.depth = penetration() / arcs_.current().frame.dishes,
                        .outward_speed = radial_speed(),
                        .approach_speed = impact_.impact().approach_speed,
                        .let_go = impact_.touched() && !contact_.walls_touch(),
                        .may_touch = !window()};
  const auto sentence = passes(scene_.bearing.rim, passage, bearing_.t);
  if (sentence) stop_impact(*sentence);
}

void FlightRun::stop_impact(const std::string &reason) {
  save();
  record_.impacts.push_back(left_open(impact_.impact())); // the force may be nil now, so the response does not tell
  throw SolverStopped(reason);
}

void FlightRun::end_contact() {
  impact_.set_rebound(-radial_speed());
  contact_.rest(record_.ledger);
  contact_.leave(bearing_);
  if (impact_.touched()) {
    record_.impacts.push_back(impact_.impact());
    write_fields();
  }
  in_contact_ = false;
  save();
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
  if (!arcs_.empty()) system_.start_afresh_at(arcs_.current().state);
}

void FlightRun::visit(StateVisitor &v) {
  v.part("bearing", [&] { visit_bearing(v, bearing_, end_time()); });
  arcs_.visit(v);
  v.flag("in_contact", in_contact_);
  v.number("next_step", next_step_, {in_contact_ ? 1e-300 : 0, 1e6});
  contact_.visit(v);
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

#include "fe_contact/drive/state_fields.h"

#include "fe_contact/drive/step_control.h"
#include <algorithm>

namespace rimpact::fe {
namespace {

constexpr double most_steps = 1e6; ///< length of a step [s], or of the load parameter

void visit(StateVisitor &v, SolidHistory &history) {
  constexpr Limits size{-1e6, 1e6}, positive{0, 1e6};
  v.rows(
      "cp_inverse", history, 6, [](J2State &point) { return point.cp_inverse.data(); }, size);
  v.column("alpha", history, &J2State::alpha, positive);
  v.column("triaxiality", history, &J2State::triaxiality, size);
  v.column("lode", history, &J2State::lode, size);
  v.column("damage", history, &J2State::damage, positive);
  v.column("locus_damage", history, &J2State::locus_damage, positive);
  v.column("overstress", history, &J2State::overstress, {-1e12, 1e12});
  v.column("viscous_work", history, &J2State::viscous_work, {-1e15, 1e15});
  bool kinematic = std::any_of(history.begin(), history.end(),
                               [](const J2State &point) { return !point.backstress.front().isZero(0); });
  v.flag("kinematic", kinematic);
  if (!kinematic) return;
  for (std::size_t k = 0; k < Backstress{}.size(); ++k)
    v.rows("backstress" + std::to_string(k), history, 6, [k](J2State &point) { return point.backstress[k].data(); },
           {-1e12, 1e12});
  v.column("back_work", history, &J2State::back_work, {-1e15, 1e15});
}

void visit(StateVisitor &v, SolidEnergies &energies) {
  v.number("elastic", energies.elastic);
  v.number("plastic", energies.plastic);
  v.number("damping", energies.damping);
}

void visit(StateVisitor &v, SurfaceContactState &s) {
  constexpr int last_status = static_cast<int>(ContactStatus::slip);
  v.numbers("multiplier", s.multiplier);
  v.numbers("gap", s.gap, infinite_too); // infinite where nothing is opposite
  v.numbers("pressure", s.pressure);
  v.points("tangential", s.tangential);
  v.points("start", s.start);
  v.points("friction", s.friction);
  v.points("pulled_back", s.pulled_back);
  v.codes("status", s.status, 0, last_status);
  v.codes("covered", s.covered, 0, 1);
  v.codes("opposite", s.opposite, -1, 1e7);
  v.numbers("entry", s.entry, {0, 1});
  v.number("stiffening", s.stiffening, {1e-12, 1e12});
  bool has_change = !s.change.empty();
  v.flag("has_change", has_change);
  if (v.reads()) s.change.resize(has_change ? s.multiplier.size() : 0);
  v.numbers("change", s.change);
}

void visit(StateVisitor &v, SurfaceContactReport &r) {
  v.point("force", r.force);
  v.point("friction", r.friction);
  v.number("largest_pressure", r.largest_pressure);
  v.integer("stick", r.stick, 0, 1e9);
  v.integer("slip", r.slip, 0, 1e9);
  v.number("smallest_gap", r.smallest_gap, infinite_too);
  v.number("penetration", r.penetration);
}

/// The change over a step, which is there if the step was.
void visit_change(StateVisitor &v, const std::string &name, double dt, Eigen::Index n, Eigen::VectorXd &change) {
  if (v.reads()) change.resize(dt > 0 ? n : 0);
  v.vector(name, change);
}

} // namespace

void visit(StateVisitor &v, SystemState &state) {
  const Eigen::Index n = state.u.size();
  v.vector("u", state.u);
  v.vector("v", state.v);
  v.vector("a", state.a);
  v.vector("R", state.R);
  v.number("last_dt", state.last_dt, {0, most_steps});
  visit_change(v, "last_change", state.last_dt, n, state.last_change);
  v.number("dt_before", state.dt_before, {0, most_steps});
  visit_change(v, "change_before", state.dt_before, n, state.change_before);
  v.integer("growth_hold", state.growth_hold, 0, 100);
  v.number("refused_error", state.refused_error, {0, most_refused_error});
  v.part("history", [&] { visit(v, state.history); });
  v.part("energies", [&] { visit(v, state.energies); });
  for (std::size_t i = 0; i < state.contacts.size(); ++i) {
    v.part("contact" + std::to_string(i), [&] { visit(v, state.contacts[i]); });
    v.part("report" + std::to_string(i), [&] { visit(v, state.reports[i]); });
  }
}

void visit(StateVisitor &v, MotionPoint &point) {
  v.number("time", point.t, {0, most_steps});
  v.number("next_step", point.next_step, {0, most_steps});
  v.part("ledger", [&] { visit(v, point.ledger); });
  v.number("scale_initial", point.scale.initial);
  v.number("scale_largest", point.scale.largest);
}

void visit(StateVisitor &v, EnergyLedger &ledger) {
  for (const auto &[name, entry] : {std::pair{"external", &EnergyLedger::external},
                                    {"gravity", &EnergyLedger::gravity},
                                    {"kinetic", &EnergyLedger::kinetic},
                                    {"elastic", &EnergyLedger::elastic},
                                    {"plastic", &EnergyLedger::plastic},
                                    {"damping", &EnergyLedger::damping},
                                    {"friction", &EnergyLedger::friction},
                                    {"impact", &EnergyLedger::impact},
                                    {"contact", &EnergyLedger::contact},
                                    {"integrator", &EnergyLedger::integrator},
                                    {"initial", &EnergyLedger::initial},
                                    {"largest_input", &EnergyLedger::largest_input}})
    v.number(name, ledger.*entry);
}

namespace {

constexpr std::pair<const char *, double Impact::*> impact_entries[] = {
    {"touch_time", &Impact::touch_time},
    {"release_time", &Impact::release_time},
    {"direction_deg", &Impact::direction_deg},
    {"approach_speed", &Impact::approach_speed},
    {"rebound_speed", &Impact::rebound_speed},
    {"peak_force", &Impact::peak_force},
    {"peak_penetration", &Impact::peak_penetration}};

} // namespace

void visit(StateVisitor &v, Impact &impact) {
  for (const auto &[name, entry] : impact_entries) v.number(name, impact.*entry);
}

void visit(StateVisitor &v, std::vector<Impact> &impacts) {
  v.length("number", impacts, 1e6, [] { return Impact{}; });
  for (const auto &[name, entry] : impact_entries) v.column(name, impacts, entry);
}

void visit(StateVisitor &v, TopDrive &drive, Eigen::Index n) {
  v.point("last_way", drive.last_way);
  if (v.reads()) drive.last_change.resize(drive.last_way.squaredNorm() > 0 ? n : 0);
  v.vector("last_change", drive.last_change);
}

void visit(StateVisitor &v, HeldRim &rim, Eigen::Index n) {
  bool deformed = rim.displacement.size() > 0;
  v.flag("deformed", deformed);
  if (v.reads()) rim.displacement.resize(deformed ? n : 0);
  v.vector("displacement", rim.displacement);
  v.part("energies", [&] { visit(v, rim.energies); });
}

} // namespace rimpact::fe

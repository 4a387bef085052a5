#include "reduced_models/record/recorder.h"
#include "reduced_models/record/inner_maximum.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace rimpact::reduced {

namespace {

const char *const columns[] = {"time",
                               "displacement_x",
                               "displacement_y",
                               "displacement_z",
                               "velocity_x",
                               "velocity_y",
                               "velocity_z",
                               "force_x",
                               "force_y",
                               "force_z",
                               "pendular_x",
                               "pendular_y",
                               "friction_x",
                               "friction_y",
                               "impact_x",
                               "impact_y",
                               "ground_acceleration_x",
                               "ground_acceleration_y",
                               "ground_acceleration_z",
                               "acceleration_x",
                               "acceleration_y",
                               "acceleration_z",
                               "gap",
                               "normal_force",
                               "energy_external",
                               "energy_gravity",
                               "energy_kinetic",
                               "energy_friction",
                               "energy_impact",
                               "energy_contact"};

const char *const temperature = "temperature";    ///< of a run whose friction goes by it
const char *const lost_in_pad = "energy_damping"; ///< of a pad that loses energy
const char *const building_energies[] = {"energy_elastic", "energy_plastic", lost_in_pad};

} // namespace

Recorder::Recorder(const Dynamics &dynamics, Response *response, double output_step, const EnergyLedger &before)
    : dynamics_(dynamics), response_(response), output_step_(output_step), contact_step_(output_step),
      last_sample_(-1e300), before_(before), final_(dynamics.n_state()), building_(dynamics.building),
      peaks_(dynamics) {
  if (dynamics.has_rim()) // at least 120 samples over the half period of mass and spring
    contact_step_ = std::min(output_step, std::numbers::pi * std::sqrt(dynamics.mass / dynamics.rim.stiffness) / 120);
  if (response_) {
    for (const char *name : columns) columns_.push_back(&response_->series(name));
    if (dynamics_.heats()) columns_.push_back(&response_->series(temperature));
    if (dynamics_.pad_retardation > 0) columns_.push_back(&response_->series(lost_in_pad));
    if (dynamics_.building.any()) {
      for (const char *name : building_energies) columns_.push_back(&response_->series(name));
      for (const auto &name : BuildingRecorder::signals()) columns_.push_back(&response_->series(name));
    }
    if (!columns_[0]->empty()) last_sample_ = columns_[0]->back();
  }
}

double Recorder::next_after(const Mode &mode, double t) const {
  if (mode.rim != RimContact::open) // a unilateral element may press again: dense until it is open
    return t + contact_step_;
  return (std::floor(t / output_step_ + 1e-9) + 1) * output_step_;
}

void Recorder::begin(const Mode &mode, double t, const State &y) {
  initial_potential_ = dynamics_.potential_energy(y);
  const Evaluation e = dynamics_.evaluate(mode, t, y);
  watch(mode, y, last_ = e);
  store(mode, t, y);
  next_sample_ = next_after(mode, t);
  if (mode.rim == RimContact::pressed) peaks_.open_impact(t, y);
}

void Recorder::watch(const Mode &mode, const State &y, const Evaluation &e) {
  peaks_.watch(mode, y, e);
  if (dynamics_.heats()) warmest_ = std::max(warmest_, dynamics_.temperature(y));
  if (dynamics_.building.any()) building_.watch(building_at(y));
}

BuildingSnapshot Recorder::building_at(const State &y) const {
  return snapshot(dynamics_.building, y, {{y[iX], y[iY], y[iZ]}, {y[iVX], y[iVY], y[iVZ]}});
}

/// A storey's drift peaks inside a step.
void Recorder::refine_drifts(const Segment &s, const State &middle) {
  const auto lateral_drift = [&](const State &y, int storey) {
    return dynamics_.building.drift(y, {y[iX], y[iY], 0}, storey).head<2>().norm();
  };
  for (int i = 0; i < dynamics_.building.n_floors(); ++i)
    building_.raise_drift(i, inner_maximum([&](double x) { return lateral_drift(s.at(s.t0 + x * (s.t1 - s.t0)), i); },
                                           lateral_drift(s.y0, i), lateral_drift(middle, i), lateral_drift(s.y1, i),
                                           building_.peak_drift(i)));
}

/// The last instant before a jump at the segment's end; of a shorter segment its begin, for what follows reads a pair
/// of samples as a jump, and may not hang on where a step ends.
void Recorder::store_before(const Mode &mode, const Segment &s) {
  if (!(s.t1 > s.t0)) return;
  const double t = std::max(s.t0, s.t1 - beside);
  State y = s.at(t);
  dynamics_.place(mode, y);
  store(mode, t, y);
}

void Recorder::segment(const Mode &mode, const Segment &s, bool rim_changes_at_end) {
  turned_ = mode.rim == RimContact::pressed && mode.support == Support::sliding &&
            std::hypot(s.y1[iVX], s.y1[iVY]) <= dynamics_.stop_speed;
  if (response_) {
    while (next_sample_ <= s.t1) {
      State y = s.at(next_sample_);
      dynamics_.place(mode, y);
      store(mode, next_sample_, y);
      next_sample_ = next_after(mode, next_sample_);
    }
    if (turned_ || (rim_changes_at_end && mode.rim != RimContact::pressed)) store_before(mode, s);
    if (rim_changes_at_end) store(mode, s.t1, s.y1);
  }
  const Evaluation e = s.end ? *s.end : dynamics_.evaluate(mode, s.t1, s.y1);
  if (s.t1 > s.t0 && !dynamics_.at_rest(mode)) {
    State y = s.at((s.t0 + s.t1) / 2);
    dynamics_.place(mode, y);
    Evaluation mid = dynamics_.evaluate(mode, (s.t0 + s.t1) / 2, y);
    watch(mode, y, mid);
    peaks_.refine(mode, s, y, last_, mid, e);
    peaks_.press(s.t1 - s.t0, last_, mid, e);
    if (dynamics_.building.any()) refine_drifts(s, y);
  }
  if (dynamics_.at_rest(mode)) peaks_.press(s.t1 - s.t0, e, e, e);
  watch(mode, s.y1, e);
  last_ = e;
  largest_input_ = std::max(largest_input_, std::abs(before_.external + s.y1[iExternal]));
  final_ = s.y1, final_time_ = s.t1, final_mode_.support = mode.support; // a run that stops ends here
}

void Recorder::branch(const Mode &before, const Mode &after, double t, const State &y, double loss) {
  landing_loss_ += loss;
  const bool pressed_before = before.rim == RimContact::pressed, pressed = after.rim == RimContact::pressed;
  if (pressed_before && !pressed) peaks_.close_impact(t, y);
  if (!pressed_before && pressed) peaks_.open_impact(t, y);
  Evaluation e = dynamics_.evaluate(after, t, y);
  watch(after, y, e);
  last_ = e;
  if (pressed_before == pressed && !turned_) return;
  if (response_ && pressed && !columns_[0]->empty() &&
      last_sample_ > t - 1e-9) { // the instant belongs to the branch that begins
    for (auto *column : columns_) column->pop_back();
    last_sample_ = columns_[0]->empty() ? -1e300 : columns_[0]->back();
  }
  if (pressed)
    store(after, t, y, 0); // however soon after another sample: where a dashpot's force begins, or friction has turned
  next_sample_ = pressed ? next_after(after, t) : t + beside;
}

void Recorder::store(const Mode &mode, double t, const State &y, double apart) {
  if (!response_ || t < last_sample_ + apart) return;
  last_sample_ = t;
  const Evaluation e = dynamics_.evaluate(mode, t, y);
  const Eigen::Vector3d force = e.pendular + e.friction + e.impact;
  const Eigen::Vector3d ground = dynamics_.ground.acceleration(t), absolute = e.acceleration + ground;
  const EnergyLedger l = ledger(mode, y);
  const double row[] = {t,           y[iX],       y[iY],     y[iZ],         y[iVX],        y[iVY],        y[iVZ],
                        force[0],    force[1],    force[2],  e.pendular[0], e.pendular[1], e.friction[0], e.friction[1],
                        e.impact[0], e.impact[1], ground[0], ground[1],     ground[2],     absolute[0],   absolute[1],
                        absolute[2], e.gap,       e.normal,  l.external,    l.gravity,     l.kinetic,     l.friction,
                        l.impact,    l.contact};
  for (std::size_t i = 0; i < std::size(row); ++i) columns_[i]->push_back(row[i]);
  if (dynamics_.heats()) response_->append(temperature, dynamics_.temperature(y));
  if (dynamics_.pad_retardation > 0) response_->append(lost_in_pad, l.damping);
  if (!dynamics_.building.any()) return;
  const double energies[] = {l.elastic, l.plastic, l.damping};
  for (int i = 0; i < 3; ++i) response_->append(building_energies[i], energies[i]);
  BuildingRecorder::append(building_at(y), dynamics_.building.n_floors(), *response_);
}

void Recorder::end(const Mode &mode, double t, const State &y) {
  store(mode, t, y);
  peaks_.end(t, y, last_.rim_force);
  final_ = y, final_time_ = t, final_mode_.support = mode.support;
}

EnergyLedger Recorder::ledger(const Mode &mode, const State &y) const {
  EnergyLedger l = before_;
  l.external += y[iExternal];
  l.gravity += dynamics_.potential_energy(y) - initial_potential_;
  l.kinetic = dynamics_.kinetic_energy(y);
  l.friction += y[iFriction];
  l.impact += y[iImpact];
  l.contact += landing_loss_;
  if (dynamics_.pad_retardation > 0) l.damping += y[iSupport];
  if (dynamics_.building.any()) {
    l.elastic += dynamics_.building.elastic_energy(y, dynamics_.base(mode, y).position);
    l.plastic += dynamics_.building.plastic_energy(y);
    l.damping += y[iDamping];
  }
  l.largest_input = std::max(before_.largest_input, largest_input_ + l.initial);
  return l;
}

void Recorder::summarise(Summary &summary, bool collapsed) const {
  peaks_.summarise(summary);
  summary.n_steps = steps.n();
  summary.residual_displacement = std::hypot(final_[iX], final_[iY]);
  summary.final_speed = std::hypot(final_[iVX], final_[iVY]);
  summary.energy = final_ledger();
  if (dynamics_.heats())
    summary.extra["friction"] = {{"peak_temperature_C", warmest_},
                                 {"final_temperature_C", dynamics_.temperature(final_)}};
  if (dynamics_.building.any())
    building_.summarise(building_at(final_), collapsed ? std::optional(final_time_) : std::nullopt, summary);
}

} // namespace rimpact::reduced

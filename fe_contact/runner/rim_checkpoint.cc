// What a dynamic run of rung R1 keeps to go on after an interruption.
#include "fe_contact/runner/record_checkpoint.h"
#include "fe_contact/runner/rim_dynamic.h"

#include <cmath>

namespace rimpact::fe {
namespace {

void put(Checkpoint &file, const std::string &prefix, const Arc &arc) {
  const ArcState &s = arc.state;
  file.numbers[prefix + "frame"] = {arc.frame.direction, double(arc.yielded), s.last_dt};
  for (const auto &[name, value] :
       {std::pair{"u", &s.u}, {"v", &s.v}, {"a", &s.a}, {"R", &s.R}, {"last_change", &s.last_change}})
    file.numbers[prefix + name] = list(*value);
  file.numbers[prefix + "history"] = list(s.history);
  file.numbers[prefix + "multiplier"] = s.contact.multiplier;
  file.numbers[prefix + "pressure"] = s.contact.pressure;
  file.numbers[prefix + "gap"] = s.contact.gap;
  file.numbers[prefix + "pressure_change"] = s.last_pressure_change;
  file.numbers[prefix + "on_wall"] = {s.contact.on_wall.begin(), s.contact.on_wall.end()};
  file.numbers[prefix + "energies"] = {s.energies.elastic, s.energies.plastic};
  file.numbers[prefix + "master"] = {s.master.x(),          s.master.y(),          s.master.z(),
                                     s.master_velocity.x(), s.master_velocity.y(), s.master_velocity.z()};
}

void get(const Checkpoint &file, const std::string &prefix, Arc &arc) {
  ArcState &s = arc.state;
  const auto &frame = file.field(prefix + "frame", 3);
  if (std::abs(frame[0]) > 7 || !flag.contains(frame[1]) || frame[2] < 0) file.damaged("field " + prefix + "frame holds a number it cannot");
  arc.frame.direction = frame[0], arc.yielded = frame[1] != 0, s.last_dt = frame[2];
  for (const auto &[name, value] : {std::pair{"u", &s.u}, {"v", &s.v}, {"a", &s.a}, {"R", &s.R}}) fe::restore(file, prefix + name, *value);
  s.last_change = last_change(file, prefix + "last_change", s.last_dt, s.u.size());
  fe::restore(file, prefix + "history", s.history);
  const std::size_t n = s.contact.gap.size();
  s.contact.multiplier = file.field(prefix + "multiplier", n), s.contact.pressure = file.field(prefix + "pressure", n);
  s.contact.gap = file.field(prefix + "gap", n);
  const auto &rate = file.field(prefix + "pressure_change"); // empty while there was no step
  s.last_pressure_change = s.last_dt > 0 || !rate.empty() ? file.field(prefix + "pressure_change", n) : rate;
  const auto &on_wall = file.field(prefix + "on_wall", n, flag);
  s.contact.on_wall.assign(on_wall.begin(), on_wall.end());
  const auto &energies = file.field(prefix + "energies", 2);
  s.energies = {energies[0], energies[1]};
  const auto &m = file.field(prefix + "master", 6, {-1e3, 1e3});
  s.master = {m[0], m[1], m[2]};
  s.master_velocity = {m[3], m[4], m[5]};
}

} // namespace

void DynamicRun::save() const {
  if (!options_.keeps_files()) return;
  Checkpoint file;
  put(file, record_);
  file.numbers["arcs"] = {double(arcs_.size()), double(in_contact_), double(touched_), double(peak_written_),
                          double(support_)};
  for (std::size_t k = 0; k < arcs_.size(); ++k) put(file, "arc" + std::to_string(k) + "_", arcs_[k]);
  file.numbers["current_arc"] = {double(current_)};
  const auto &b = bearing_;
  file.numbers["bearing"] = {
      b.t, b.u.x(), b.u.y(), b.u.z(), b.v.x(), b.v.y(), b.v.z(), double(b.airborne), b.eta.x(), b.eta.y()};
  file.numbers["step"] = {dt_, multiplier_, others_elastic_, others_plastic_, lift_height_};
  file.numbers["impact_now"] = list(impact_);
  write_checkpoint(file, checkpoint_of(options_));
}

void DynamicRun::restore() {
  const Checkpoint file = kept_checkpoint(options_, record_);
  get(file, record_);
  const auto &a = file.field("arcs", 5, count);
  constexpr double most_arcs = 1000;
  if (a[0] > most_arcs || a[1] > 1 || a[2] > 1 || a[3] > 1 || a[4] > static_cast<int>(Support::held)) file.damaged("field arcs holds a number it cannot");
  in_contact_ = a[1] != 0, touched_ = a[2] != 0, peak_written_ = a[3] != 0,
  support_ = static_cast<Support>(int(a[4]));
  for (int k = 0; k < int(a[0]); ++k) {
    arcs_.push_back({{0, capacity(), touch_height_}, solver_.virgin(), false});
    get(file, "arc" + std::to_string(k) + "_", arcs_.back());
  }
  current_ = static_cast<std::size_t>(file.number("current_arc", {0, most_arcs, true}));
  if (in_contact_ && current_ >= arcs_.size()) file.damaged("field current_arc names an arc that is not there");
  const auto &b = file.field("bearing", 10, {-1e4, 1e4});
  if (b[0] < 0 || b[0] > end_time() + 1e-9 || !flag.contains(b[7])) file.damaged("field bearing holds a number it cannot");
  bearing_ = {b[0], {b[1], b[2], b[3]}, {b[4], b[5], b[6]}, b[7] != 0, {b[8], b[9]}, {}};
  const auto &s = file.field("step", 5);
  if (s[0] < 0 || (in_contact_ && !(s[0] > 0))) file.damaged("field step holds no length of a step");
  dt_ = s[0], multiplier_ = s[1], others_elastic_ = s[2], others_plastic_ = s[3], lift_height_ = s[4];
  impact_ = impact_from(file, "impact_now");
}

} // namespace rimpact::fe

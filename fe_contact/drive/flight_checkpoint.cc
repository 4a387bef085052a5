// What a dynamic run of rung rim keeps to go on after an interruption.
#include "fe_contact/drive/flight_run.h"
#include "fe_contact/drive/record_checkpoint.h"
#include "fe_contact/drive/system_checkpoint.h"

#include <cmath>

namespace rimpact::fe {
namespace {

std::string arc_prefix(std::size_t k) {
  return "arc" + std::to_string(k) + "_";
}

void put(Checkpoint &file, const std::string &prefix, const Arc &arc) {
  file.numbers[prefix + "frame"] = {arc.frame.direction, double(arc.yielded)};
  fe::put(file, arc.state, prefix);
}

void get(const Checkpoint &file, const std::string &prefix, Arc &arc) {
  const auto &frame = file.field(prefix + "frame", 2);
  if (std::abs(frame[0]) > 7 || !flag.contains(frame[1]))
    file.damaged("field " + prefix + "frame holds a number it cannot");
  arc.frame.direction = frame[0], arc.yielded = frame[1] != 0;
  fe::get(file, arc.state, prefix);
}

} // namespace

void FlightRun::save() {
  if (options_.folder.empty()) return;
  if (!arcs_.empty()) system_.start_afresh_at(arcs_[current_].state); // as the run that reads it will
  steps_kept_ = record_.n_steps;
  if (!options_.keeps_files()) return;
  Checkpoint file;
  put(file, record_);
  file.numbers["arcs"] = {double(arcs_.size()), double(in_contact_), double(touched_), double(peak_written_),
                          double(support_)};
  for (std::size_t k = 0; k < arcs_.size(); ++k) put(file, arc_prefix(k), arcs_[k]);
  file.numbers["current_arc"] = {double(current_)};
  const auto &b = bearing_;
  file.numbers["bearing"] = {b.t,       b.u.x(),  b.u.y(), b.u.z(), b.v.x(), b.v.y(), b.v.z(), double(b.airborne),
                             b.eta.x(), b.eta.y()};
  file.numbers["step"] = {dt_, multiplier_, others_elastic_, others_plastic_, lift_height_};
  file.numbers["impact_now"] = list(impact_);
  write_checkpoint(file, checkpoint_of(options_));
}

void FlightRun::restore() {
  const Checkpoint file = kept_checkpoint(options_, record_);
  get(file, record_);
  const auto &a = file.field("arcs", 5, count);
  constexpr double most_arcs = 1000;
  if (a[0] > most_arcs || a[1] > 1 || a[2] > 1 || a[3] > 1 || a[4] > static_cast<int>(Support::held))
    file.damaged("field arcs holds a number it cannot");
  in_contact_ = a[1] != 0, touched_ = a[2] != 0, peak_written_ = a[3] != 0, support_ = static_cast<Support>(int(a[4]));
  for (int k = 0; k < int(a[0]); ++k) {
    arcs_.push_back({{0, capacity(), touch_height_}, system_.at_rest(), false});
    get(file, arc_prefix(k), arcs_.back());
  }
  current_ = static_cast<std::size_t>(file.number("current_arc", {0, most_arcs, true}));
  if (!arcs_.empty() && current_ >= arcs_.size()) file.damaged("field current_arc names an arc that is not there");
  const auto &b = file.field("bearing", 10, {-1e4, 1e4});
  if (b[0] < 0 || b[0] > end_time() + 1e-9 || !flag.contains(b[7]))
    file.damaged("field bearing holds a number it cannot");
  bearing_ = {b[0], {b[1], b[2], b[3]}, {b[4], b[5], b[6]}, b[7] != 0, {b[8], b[9]}, {}};
  const auto &s = file.field("step", 5);
  if (s[0] < 0 || (in_contact_ && !(s[0] > 0))) file.damaged("field step holds no length of a step");
  dt_ = s[0], multiplier_ = s[1], others_elastic_ = s[2], others_plastic_ = s[3], lift_height_ = s[4];
  impact_ = impact_from(file, "impact_now");
  steps_kept_ = record_.n_steps;
  if (!arcs_.empty()) system_.start_afresh_at(arcs_[current_].state);
}

} // namespace rimpact::fe

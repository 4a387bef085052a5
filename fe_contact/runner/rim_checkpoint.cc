// What a dynamic run of rung R1 keeps to go on after an interruption.
#include "fe_contact/runner/record_checkpoint.h"
#include "fe_contact/runner/rim_dynamic.h"

#include "scene/error.h"

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
  const auto numbers = [&](const char *name) -> const std::vector<double> & { return fe::numbers(file, prefix + name); };
  ArcState &s = arc.state;
  if (numbers("u").size() != std::size_t(s.u.size()))
    throw DataError("the checkpoint belongs to another mesh: it has " + std::to_string(numbers("u").size()) +
                    " unknowns, this run " + std::to_string(s.u.size()));
  arc.frame.direction = numbers("frame")[0];
  arc.yielded = numbers("frame")[1] != 0;
  s.last_dt = numbers("frame")[2];
  s.u = vector(numbers("u")), s.v = vector(numbers("v")), s.a = vector(numbers("a")),
  s.R = vector(numbers("R"));
  s.last_change = vector(numbers("last_change"));
  restore(numbers("history"), s.history);
  s.contact.multiplier = numbers("multiplier"), s.contact.pressure = numbers("pressure"),
  s.contact.gap = numbers("gap"), s.last_pressure_change = numbers("pressure_change");
  s.contact.on_wall.assign(numbers("on_wall").begin(), numbers("on_wall").end());
  s.energies = {numbers("energies")[0], numbers("energies")[1]};
  const auto &m = numbers("master");
  s.master = {m[0], m[1], m[2]};
  s.master_velocity = {m[3], m[4], m[5]};
}

} // namespace

void DynamicRun::save() const {
  if (!options_.keeps_files()) return;
  Checkpoint file;
  put(file, scene_, record_);
  file.numbers["arcs"] = {double(arcs_.size()), double(in_contact_), double(touched_), double(peak_written_),
                          double(support_)};
  for (std::size_t k = 0; k < arcs_.size(); ++k) put(file, "arc" + std::to_string(k) + "_", arcs_[k]);
  file.numbers["current_arc"] = {double(current_)};
  const auto &b = bearing_;
  file.numbers["bearing"] = {
      b.t, b.u.x(), b.u.y(), b.u.z(), b.v.x(), b.v.y(), b.v.z(), double(b.airborne), b.eta.x(), b.eta.y()};
  file.numbers["step"] = {dt_, multiplier_, others_elastic_, others_plastic_, lift_height_};
  file.numbers["impact_now"] = list(impact_);
  write_checkpoint(file, options_.folder + "/checkpoint.h5");
}

void DynamicRun::restore() {
  const std::string path = options_.folder + "/checkpoint.h5";
  const Checkpoint file = read_checkpoint(path);
  get(file, path, scene_, record_);
  const auto &a = file.numbers.at("arcs");
  in_contact_ = a[1] != 0, touched_ = a[2] != 0, peak_written_ = a[3] != 0,
  support_ = static_cast<Support>(int(a[4]));
  for (int k = 0; k < int(a[0]); ++k) {
    arcs_.push_back({{0, capacity(), touch_height_}, solver_.virgin(), false});
    get(file, "arc" + std::to_string(k) + "_", arcs_.back());
  }
  current_ = int(file.number("current_arc"));
  const auto &b = file.numbers.at("bearing");
  bearing_ = {b[0], {b[1], b[2], b[3]}, {b[4], b[5], b[6]}, b[7] != 0, {b[8], b[9]}, {}};
  const auto &s = file.numbers.at("step");
  dt_ = s[0], multiplier_ = s[1], others_elastic_ = s[2], others_plastic_ = s[3], lift_height_ = s[4];
  impact_ = impact_from(numbers(file, "impact_now"));
}

} // namespace rimpact::fe

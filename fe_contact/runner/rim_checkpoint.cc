// What a dynamic run of rung R1 keeps to go on after an interruption.
#include "fe_contact/runner/rim_dynamic.h"

#include "scene/error.h"

namespace rimpact::fe {
namespace {

std::string signature(const scene::Scene &scene) {
  return std::string(RIMPACT_VERSION) + "\n" + scene::to_toml(scene);
}

std::vector<double> list(const Eigen::VectorXd &v) {
  return {v.data(), v.data() + v.size()};
}
Eigen::VectorXd vector(const std::vector<double> &v) {
  return Eigen::Map<const Eigen::VectorXd>(v.data(), v.size());
}

void put(Checkpoint &file, const std::string &prefix, const Arc &arc) {
  const ArcState &s = arc.state;
  file.numbers[prefix + "frame"] = {arc.frame.direction, double(arc.yielded), s.last_dt};
  for (const auto &[name, value] :
       {std::pair{"u", &s.u}, {"v", &s.v}, {"a", &s.a}, {"R", &s.R}, {"last_change", &s.last_change}})
    file.numbers[prefix + name] = list(*value);
  auto &history = file.numbers[prefix + "history"];
  for (const auto &point : s.history) {
    history.insert(history.end(), point.cp_inverse.data(), point.cp_inverse.data() + 6);
    history.push_back(point.alpha);
  }
  file.numbers[prefix + "multiplier"] = s.contact.multiplier;
  file.numbers[prefix + "pressure"] = s.contact.pressure;
  file.numbers[prefix + "gap"] = s.contact.gap;
  file.numbers[prefix + "on_wall"] = {s.contact.on_wall.begin(), s.contact.on_wall.end()};
  file.numbers[prefix + "energies"] = {s.energies.elastic, s.energies.plastic};
  file.numbers[prefix + "master"] = {s.master.x(),          s.master.y(),          s.master.z(),
                                     s.master_velocity.x(), s.master_velocity.y(), s.master_velocity.z()};
}

void get(const Checkpoint &file, const std::string &prefix, Arc &arc) {
  const auto numbers = [&](const char *name) -> const std::vector<double> & {
    file.number(prefix + "frame"); // says what is missing
    return file.numbers.at(prefix + name);
  };
  ArcState &s = arc.state;
  if (numbers("u").size() != std::size_t(s.u.size()) || numbers("history").size() != 7 * s.history.size())
    throw DataError("the checkpoint belongs to another mesh: it has " + std::to_string(numbers("u").size()) +
                    " unknowns, this run " + std::to_string(s.u.size()));
  arc.frame.direction = numbers("frame")[0];
  arc.yielded = numbers("frame")[1] != 0;
  s.last_dt = numbers("frame")[2];
  s.u = vector(numbers("u")), s.v = vector(numbers("v")), s.a = vector(numbers("a")),
  s.R = vector(numbers("R"));
  s.last_change = vector(numbers("last_change"));
  for (std::size_t k = 0; k < s.history.size(); ++k) {
    for (int i = 0; i < 6; ++i) s.history[k].cp_inverse[i] = numbers("history")[7 * k + i];
    s.history[k].alpha = numbers("history")[7 * k + 6];
  }
  s.contact.multiplier = numbers("multiplier"), s.contact.pressure = numbers("pressure"),
  s.contact.gap = numbers("gap");
  s.contact.on_wall.assign(numbers("on_wall").begin(), numbers("on_wall").end());
  s.energies = {numbers("energies")[0], numbers("energies")[1]};
  const auto &m = numbers("master");
  s.master = {m[0], m[1], m[2]};
  s.master_velocity = {m[3], m[4], m[5]};
}

} // namespace

void DynamicRun::save() const {
  if (options_.folder.empty()) return;
  Checkpoint file;
  file.texts["signature"] = signature(scene_);
  file.numbers["arcs"] = {double(arcs_.size()), double(in_contact_), double(touched_), double(peak_written_),
                          double(support_)};
  for (std::size_t k = 0; k < arcs_.size(); ++k) put(file, "arc" + std::to_string(k) + "_", arcs_[k]);
  file.numbers["current_arc"] = {double(current_)};
  const auto &b = bearing_;
  file.numbers["bearing"] = {
      b.t, b.u.x(), b.u.y(), b.u.z(), b.v.x(), b.v.y(), b.v.z(), double(b.airborne), b.eta.x(), b.eta.y()};
  file.numbers["step"] = {dt_, multiplier_, others_elastic_, others_plastic_};
  const auto &e = record_.ledger;
  file.numbers["ledger"] = {e.external, e.gravity, e.kinetic,    e.elastic, e.plastic,      e.friction,
                            e.impact,   e.contact, e.integrator, e.initial, e.largest_input};
  auto &impacts = file.numbers["impacts"];
  auto all = record_.impacts;
  all.push_back(impact_);
  for (const auto &i : all)
    impacts.insert(impacts.end(), {i.touch_time, i.release_time, i.direction_deg, i.approach_speed,
                                   i.rebound_speed, i.peak_force, i.peak_penetration});
  file.numbers["counts"] = {double(record_.n_steps), double(record_.n_newton), double(record_.n_cuts),
                            double(record_.augmentation_caps), record_.smallest_normal};
  for (const auto &[name, values] : record_.response.all()) file.numbers["response_" + name] = values;
  for (const auto &[time, name] : record_.fields)
    file.numbers["field_" + name.substr(name.find('/') + 1)] = {time};
  write_checkpoint(file, options_.folder + "/checkpoint.h5");
}

void DynamicRun::restore() {
  const std::string path = options_.folder + "/checkpoint.h5";
  const Checkpoint file = read_checkpoint(path);
  const auto text = file.texts.find("signature");
  if (text == file.texts.end() || text->second != signature(scene_))
    throw DataError(
        path + ": written by another version or for another scene; run without --resume to start afresh");
  const auto &a = file.numbers.at("arcs");
  in_contact_ = a[1] != 0, touched_ = a[2] != 0, peak_written_ = a[3] != 0,
  support_ = static_cast<Support>(int(a[4]));
  for (int k = 0; k < int(a[0]); ++k) {
    arcs_.push_back({{0, capacity(), touch_height_}, solver_.virgin(), false});
    get(file, "arc" + std::to_string(k) + "_", arcs_.back());
  }
  current_ = int(file.number("current_arc"));
  const auto &b = file.numbers.at("bearing");
  bearing_ = {b[0], {b[1], b[2], b[3]}, {b[4], b[5], b[6]}, b[7] != 0, {b[8], b[9]}};
  const auto &s = file.numbers.at("step");
  dt_ = s[0], multiplier_ = s[1], others_elastic_ = s[2], others_plastic_ = s[3];
  const auto &e = file.numbers.at("ledger");
  record_.ledger = {e[0], e[1], e[2], e[3], e[4], e[5], e[6], e[7], e[8], e[9], e[10]};
  const auto &impacts = file.numbers.at("impacts");
  for (std::size_t k = 0; k + 6 < impacts.size(); k += 7)
    record_.impacts.push_back({impacts[k], impacts[k + 1], impacts[k + 2], impacts[k + 3], impacts[k + 4],
                               impacts[k + 5], impacts[k + 6]});
  impact_ = record_.impacts.back();
  record_.impacts.pop_back();
  const auto &n = file.numbers.at("counts");
  record_.n_steps = n[0], record_.n_newton = n[1], record_.n_cuts = n[2], record_.augmentation_caps = n[3],
  record_.smallest_normal = n[4];
  for (const auto &[name, values] : file.numbers) {
    if (name.rfind("response_", 0) == 0)
      for (const double value : values) record_.response.append(name.substr(9), value);
    if (name.rfind("field_", 0) == 0) record_.fields.emplace_back(values[0], "fields/" + name.substr(6));
  }
}

} // namespace rimpact::fe

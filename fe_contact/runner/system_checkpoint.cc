#include "fe_contact/runner/system_checkpoint.h"

#include "fe_contact/runner/record_checkpoint.h"
#include "scene/error.h"

namespace rimpact::fe {
namespace {

std::vector<double> flat(const std::vector<Eigen::Vector3d> &vectors) {
  std::vector<double> result;
  for (const auto &v : vectors) result.insert(result.end(), v.data(), v.data() + 3);
  return result;
}
void restore(const std::vector<double> &numbers, std::vector<Eigen::Vector3d> &vectors) {
  for (std::size_t k = 0; k < vectors.size(); ++k) vectors[k] = Eigen::Map<const Eigen::Vector3d>(&numbers[3 * k]);
}

void put(Checkpoint &file, const std::string &prefix, const SurfaceContactState &s) {
  auto &n = file.numbers;
  n[prefix + "multiplier"] = s.multiplier;
  n[prefix + "gap"] = s.gap;
  n[prefix + "pressure"] = s.pressure;
  n[prefix + "tangential"] = flat(s.tangential);
  n[prefix + "start"] = flat(s.start);
  n[prefix + "friction"] = flat(s.friction);
  for (const ContactStatus status : s.status) n[prefix + "status"].push_back(static_cast<double>(status));
  n[prefix + "covered"] = {s.covered.begin(), s.covered.end()};
  n[prefix + "opposite"] = {s.opposite.begin(), s.opposite.end()};
  n[prefix + "stiffening"] = {s.stiffening};
}

void get(const Checkpoint &file, const std::string &prefix, SurfaceContactState &s) {
  const auto array = [&](const char *name) -> const std::vector<double> & { return numbers(file, prefix + name); };
  if (array("multiplier").size() != s.multiplier.size()) throw DataError("the checkpoint belongs to another mesh: its contacts have other points");
  s.multiplier = array("multiplier"), s.gap = array("gap"), s.pressure = array("pressure");
  restore(array("tangential"), s.tangential);
  restore(array("start"), s.start);
  restore(array("friction"), s.friction);
  for (std::size_t k = 0; k < s.status.size(); ++k) {
    s.status[k] = static_cast<ContactStatus>(static_cast<char>(array("status")[k]));
    s.covered[k] = array("covered")[k] != 0;
    s.opposite[k] = static_cast<int>(array("opposite")[k]);
  }
  s.stiffening = array("stiffening")[0];
}

} // namespace

void put(Checkpoint &file, const SystemState &state) {
  for (const auto &[name, value] : {std::pair{"u", &state.u}, {"v", &state.v}, {"a", &state.a}, {"R", &state.R}})
    file.numbers[name] = list(*value);
  file.numbers["last_change"] = list(state.last_change);
  file.numbers["last_dt"] = {state.last_dt};
  file.numbers["history"] = list(state.history);
  file.numbers["energies"] = {state.energies.elastic, state.energies.plastic};
  for (std::size_t i = 0; i < state.contacts.size(); ++i) {
    put(file, "contact" + std::to_string(i) + "_", state.contacts[i]);
    const auto &r = state.reports[i];
    file.numbers["report" + std::to_string(i)] = {r.force.x(),    r.force.y(),    r.force.z(),
                                                  r.friction.x(), r.friction.y(), r.friction.z(),
                                                  r.largest_pressure, double(r.stick), double(r.slip),
                                                  r.smallest_gap, r.penetration};
  }
}

void get(const Checkpoint &file, SystemState &state) {
  if (numbers(file, "u").size() != std::size_t(state.u.size()))
    throw DataError("the checkpoint belongs to another mesh: it has " + std::to_string(numbers(file, "u").size()) +
                    " unknowns, this run " + std::to_string(state.u.size()));
  for (const auto &[name, value] : {std::pair{"u", &state.u}, {"v", &state.v}, {"a", &state.a}, {"R", &state.R}})
    *value = vector(numbers(file, name));
  state.last_change = vector(numbers(file, "last_change"));
  state.last_dt = numbers(file, "last_dt")[0];
  restore(numbers(file, "history"), state.history);
  state.energies = {numbers(file, "energies")[0], numbers(file, "energies")[1]};
  for (std::size_t i = 0; i < state.contacts.size(); ++i) {
    get(file, "contact" + std::to_string(i) + "_", state.contacts[i]);
    const auto &v = numbers(file, "report" + std::to_string(i));
    if (v.size() != 11) throw DataError("the checkpoint belongs to another version: its contacts' reports have other numbers");
    auto &r = state.reports[i];
    r.force = {v[0], v[1], v[2]};
    r.friction = {v[3], v[4], v[5]};
    r.largest_pressure = v[6], r.stick = int(v[7]), r.slip = int(v[8]), r.smallest_gap = v[9], r.penetration = v[10];
  }
}

void put(Checkpoint &file, const TransientPoint &point) {
  const SystemLedger &e = point.ledger;
  file.numbers["march"] = {point.t,   point.next_step, e.initial, e.external,   e.kinetic, e.elastic,
                           e.plastic, e.friction,      e.contact, e.integrator, e.largest};
}

void get(const Checkpoint &file, TransientPoint &point) {
  const auto &v = numbers(file, "march");
  if (v.size() != 11) throw DataError("the checkpoint belongs to another version: its march has other numbers");
  point = {v[0], v[1], {v[2], v[3], v[4], v[5], v[6], v[7], v[8], v[9], v[10]}};
}

} // namespace rimpact::fe

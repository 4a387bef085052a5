#include "fe_contact/drive/system_checkpoint.h"

#include "fe_contact/drive/record_checkpoint.h"

namespace rimpact::fe {
namespace {

std::vector<double> flat(const std::vector<Eigen::Vector3d> &vectors) {
  std::vector<double> result;
  for (const auto &v : vectors) result.insert(result.end(), v.data(), v.data() + 3);
  return result;
}
void restore(const Checkpoint &file, const std::string &name, std::vector<Eigen::Vector3d> &vectors) {
  const auto &numbers = file.field(name, 3 * vectors.size());
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
  n[prefix + "pulled_back"] = flat(s.pulled_back);
  n[prefix + "status"] = {};
  for (const ContactStatus status : s.status) n[prefix + "status"].push_back(static_cast<double>(status));
  n[prefix + "covered"] = {s.covered.begin(), s.covered.end()};
  n[prefix + "opposite"] = {s.opposite.begin(), s.opposite.end()};
  n[prefix + "stiffening"] = {s.stiffening};
  n[prefix + "change"] = s.change;
}

void get(const Checkpoint &file, const std::string &prefix, SurfaceContactState &s) {
  const std::size_t n = s.multiplier.size();
  s.multiplier = file.field(prefix + "multiplier", n);
  s.gap = file.field(prefix + "gap", n, infinite_too); // infinite where nothing is opposite
  s.pressure = file.field(prefix + "pressure", n);
  restore(file, prefix + "tangential", s.tangential);
  restore(file, prefix + "start", s.start);
  restore(file, prefix + "friction", s.friction);
  restore(file, prefix + "pulled_back", s.pulled_back);
  const auto &status = file.field(prefix + "status", n, {0, 2, true}),
             &covered = file.field(prefix + "covered", n, flag),
             &opposite = file.field(prefix + "opposite", n, {-1, 1e7, true});
  for (std::size_t k = 0; k < n; ++k) {
    s.status[k] = static_cast<ContactStatus>(static_cast<char>(status[k]));
    s.covered[k] = covered[k] != 0;
    s.opposite[k] = static_cast<int>(opposite[k]);
  }
  s.stiffening = file.number(prefix + "stiffening", {1e-12, 1e12});
  const auto &change = file.field(prefix + "change"); // empty while there was no step
  s.change = change.empty() ? change : file.field(prefix + "change", n);
}

} // namespace

void put(Checkpoint &file, const SystemState &state, const std::string &prefix) {
  for (const auto &[name, value] : {std::pair{"u", &state.u}, {"v", &state.v}, {"a", &state.a}, {"R", &state.R}})
    file.numbers[prefix + name] = list(*value);
  file.numbers[prefix + "last_change"] = list(state.last_change);
  file.numbers[prefix + "last_dt"] = {state.last_dt};
  file.numbers[prefix + "change_before"] = list(state.change_before);
  file.numbers[prefix + "dt_before"] = {state.dt_before};
  file.numbers[prefix + "calm"] = {double(state.calm)};
  file.numbers[prefix + "history"] = list(state.history);
  file.numbers[prefix + "energies"] = {state.energies.elastic, state.energies.plastic};
  for (std::size_t i = 0; i < state.contacts.size(); ++i) {
    put(file, prefix + "contact" + std::to_string(i) + "_", state.contacts[i]);
    const auto &r = state.reports[i];
    file.numbers[prefix + "report" + std::to_string(i)] = {
        r.force.x(),        r.force.y(),     r.force.z(),    r.friction.x(), r.friction.y(), r.friction.z(),
        r.largest_pressure, double(r.stick), double(r.slip), r.smallest_gap, r.penetration};
  }
}

void get(const Checkpoint &file, SystemState &state, const std::string &prefix) {
  for (const auto &[name, value] : {std::pair{"u", &state.u}, {"v", &state.v}, {"a", &state.a}, {"R", &state.R}})
    restore(file, prefix + name, *value);
  state.last_dt = file.number(prefix + "last_dt", {0, 1e6});
  state.last_change = last_change(file, prefix + "last_change", state.last_dt, state.u.size());
  state.dt_before = file.number(prefix + "dt_before", {0, 1e6});
  state.calm = static_cast<int>(file.number(prefix + "calm", {0, 100, true}));
  state.change_before = last_change(file, prefix + "change_before", state.dt_before, state.u.size());
  restore(file, prefix + "history", state.history);
  const auto &energies = file.field(prefix + "energies", 2);
  state.energies = {energies[0], energies[1]};
  for (std::size_t i = 0; i < state.contacts.size(); ++i) {
    get(file, prefix + "contact" + std::to_string(i) + "_", state.contacts[i]);
    const auto &v =
        file.field(prefix + "report" + std::to_string(i), 11, infinite_too); // the smallest gap may be infinite
    for (std::size_t k = 0; k < v.size(); ++k)
      if (k != 9 && !Limits{}.contains(v[k]))
        file.damaged("field " + prefix + "report" + std::to_string(i) + " holds a number that is not finite");
    if (!count.contains(v[7]) || !count.contains(v[8]))
      file.damaged("field " + prefix + "report" + std::to_string(i) + " holds no count of points");
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
  const auto &v = file.field("march", 11);
  point = {v[0], v[1], {v[2], v[3], v[4], v[5], v[6], v[7], v[8], v[9], v[10]}};
}

} // namespace rimpact::fe

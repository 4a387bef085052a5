#include "fe_contact/runner/record_checkpoint.h"

#include "scene/error.h"
#include <sstream>

namespace rimpact::fe {
namespace {
std::string signature(const scene::Scene &scene) {
  return std::string(RIMPACT_VERSION) + "\n" + scene::to_toml(scene);
}
constexpr std::size_t per_point = 7, per_impact = 7;
/// By name: the ledger may gain entries that no finite-element run fills.
using LedgerEntry = double scene::EnergyLedger::*;
constexpr LedgerEntry ledger_entries[] = {
    &scene::EnergyLedger::external, &scene::EnergyLedger::gravity,    &scene::EnergyLedger::kinetic,
    &scene::EnergyLedger::elastic,  &scene::EnergyLedger::plastic,    &scene::EnergyLedger::friction,
    &scene::EnergyLedger::impact,   &scene::EnergyLedger::contact,    &scene::EnergyLedger::integrator,
    &scene::EnergyLedger::initial,  &scene::EnergyLedger::largest_input};
} // namespace

std::vector<double> list(const Eigen::VectorXd &v) { return {v.data(), v.data() + v.size()}; }

Eigen::VectorXd vector(const std::vector<double> &v) { return Eigen::Map<const Eigen::VectorXd>(v.data(), v.size()); }

std::vector<double> list(const SolidHistory &history) {
  std::vector<double> result;
  result.reserve(per_point * history.size());
  for (const auto &point : history) {
    result.insert(result.end(), point.cp_inverse.data(), point.cp_inverse.data() + 6);
    result.push_back(point.alpha);
  }
  return result;
}

void restore(const std::vector<double> &numbers, SolidHistory &history) {
  if (numbers.size() != per_point * history.size())
    throw DataError("the checkpoint belongs to another mesh: it has " + std::to_string(numbers.size() / per_point) +
                    " material points, this run " + std::to_string(history.size()));
  for (std::size_t k = 0; k < history.size(); ++k) {
    for (int i = 0; i < 6; ++i) history[k].cp_inverse[i] = numbers[per_point * k + i];
    history[k].alpha = numbers[per_point * k + 6];
  }
}

const std::vector<double> &numbers(const Checkpoint &file, const std::string &name) {
  const auto found = file.numbers.find(name);
  if (found == file.numbers.end()) throw DataError("the checkpoint lacks '" + name + "': run without --resume to start afresh");
  return found->second;
}

std::vector<double> list(const scene::Impact &i) {
  return {i.touch_time, i.release_time, i.direction_deg, i.approach_speed, i.rebound_speed, i.peak_force, i.peak_penetration};
}

scene::Impact impact_from(const std::vector<double> &v) { return {v[0], v[1], v[2], v[3], v[4], v[5], v[6]}; }

void put(Checkpoint &file, const scene::Scene &scene, const RunRecord &record) {
  file.texts["signature"] = signature(scene);
  for (const auto &warning : record.warnings) file.texts["warnings"] += warning + "\n";
  for (const LedgerEntry entry : ledger_entries) file.numbers["ledger"].push_back(record.ledger.*entry);
  auto &impacts = file.numbers["impacts"];
  for (const auto &impact : record.impacts)
    for (const double value : list(impact)) impacts.push_back(value);
  file.numbers["counts"] = {double(record.n_steps), double(record.n_newton), double(record.n_cuts),
                            double(record.augmentation_caps)};
  for (const auto &[name, values] : record.response.all()) file.numbers["response_" + name] = values;
  file.numbers["seconds_wall"] = {record.wall_so_far()};
  for (const auto &[name, seconds] : record.split_so_far()) file.numbers["seconds_" + name] = {seconds};
  for (const auto &[time, name] : record.fields) file.numbers["field_" + name.substr(name.find('/') + 1)] = {time};
}

void get(const Checkpoint &file, const std::string &path, const scene::Scene &scene, RunRecord &record) {
  const auto text = file.texts.find("signature");
  if (text == file.texts.end() || text->second != signature(scene))
    throw DataError(path + ": written by another version or for another scene; run without --resume to start afresh");
  if (const auto warnings = file.texts.find("warnings"); warnings != file.texts.end()) {
    std::istringstream lines(warnings->second);
    for (std::string line; std::getline(lines, line);) record.warnings.push_back(line);
  }
  const auto &ledger = numbers(file, "ledger");
  for (std::size_t k = 0; k < std::size(ledger_entries); ++k) record.ledger.*ledger_entries[k] = ledger.at(k);
  const auto &impacts = numbers(file, "impacts");
  for (std::size_t k = 0; k + per_impact <= impacts.size(); k += per_impact)
    record.impacts.push_back(impact_from({impacts.begin() + k, impacts.begin() + k + per_impact}));
  const auto &n = numbers(file, "counts");
  record.n_steps = n[0], record.n_newton = n[1], record.n_cuts = n[2], record.augmentation_caps = n[3];
  for (const auto &[name, values] : file.numbers) {
    if (name.rfind("response_", 0) == 0)
      for (const double value : values) record.response.append(name.substr(9), value);
    if (name == "seconds_wall")
      record.earlier_wall = values[0];
    else if (name.rfind("seconds_", 0) == 0)
      record.time_split[name.substr(8)] = values[0];
    if (name.rfind("field_", 0) == 0) record.fields.emplace_back(values[0], "fields/" + name.substr(6));
  }
}

} // namespace rimpact::fe

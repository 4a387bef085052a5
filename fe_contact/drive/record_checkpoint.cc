#include "fe_contact/drive/record_checkpoint.h"

#include "fe_contact/drive/sample_row.h"
#include "fe_contact/drive/solver_counts.h"
#include "fe_contact/solver/ranks.h"
#include "files/error.h"
#include "files/json_text.h"
#include "responses/identity.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <sstream>

namespace rimpact::fe {
namespace {

constexpr std::size_t per_point = 9, per_impact = 7;
constexpr Limits seconds{0, 1e12};
/// By name: the ledger may gain entries that no finite-element run fills.
using LedgerEntry = double EnergyLedger::*;
constexpr LedgerEntry ledger_entries[] = {
    &EnergyLedger::external,   &EnergyLedger::gravity,  &EnergyLedger::kinetic,      &EnergyLedger::elastic,
    &EnergyLedger::plastic,    &EnergyLedger::friction, &EnergyLedger::impact,       &EnergyLedger::contact,
    &EnergyLedger::integrator, &EnergyLedger::initial,  &EnergyLedger::largest_input};

Impact impact_of(const double *v) {
  return {v[0], v[1], v[2], v[3], v[4], v[5], v[6]};
}

/// Every signal of a finite-element run, each as long as the time.
void get_response(const Checkpoint &file, RunRecord &record) {
  if (!file.has("response_time")) return; // no instant was stored yet
  const auto &time = file.field("response_time", Limits{-1e-9, 1e6});
  if (!std::is_sorted(time.begin(), time.end())) file.damaged("field response_time runs back");
  RunRecord example;
  append(example, {});
  for (const auto &[name, unused] : example.response.all()) file.field("response_" + name, time.size());
  std::istringstream due(file.text("signals"));
  for (std::string name; std::getline(due, name);) file.field("response_" + name, time.size());
  const auto &known = known_signals();
  for (const auto &[name, values] : file.numbers) {
    if (!name.starts_with("response_")) continue;
    const std::string signal = name.substr(9);
    if (std::none_of(known.begin(), known.end(), [&](const auto &info) { return info.name == signal; }))
      file.damaged("field " + name + " is not known");
    record.response.series(signal) = file.field(name, time.size());
  }
}

} // namespace

std::vector<double> list(const Eigen::VectorXd &v) {
  return {v.data(), v.data() + v.size()};
}

Eigen::VectorXd vector(const std::vector<double> &v) {
  return Eigen::Map<const Eigen::VectorXd>(v.data(), v.size());
}

std::vector<double> list(const SolidHistory &history) {
  std::vector<double> result;
  result.reserve(per_point * history.size());
  for (const auto &point : history) {
    result.insert(result.end(), point.cp_inverse.data(), point.cp_inverse.data() + 6);
    result.insert(result.end(), {point.alpha, point.triaxiality, point.damage});
  }
  return result;
}

void restore(const Checkpoint &file, const std::string &name, SolidHistory &history) {
  const auto &numbers = file.field(name, per_point * history.size(), Limits{-1e6, 1e6});
  for (std::size_t k = 0; k < history.size(); ++k) {
    for (int i = 0; i < 6; ++i) history[k].cp_inverse[i] = numbers[per_point * k + i];
    history[k].alpha = numbers[per_point * k + 6];
    history[k].triaxiality = numbers[per_point * k + 7];
    history[k].damage = numbers[per_point * k + 8];
    if (history[k].alpha < 0 || history[k].damage < 0)
      file.damaged(fmt::format("field {} holds a negative plastic strain or damage", name));
  }
}

void restore(const Checkpoint &file, const std::string &name, Eigen::VectorXd &v) {
  v = vector(file.field(name, static_cast<std::size_t>(v.size())));
}

Eigen::VectorXd last_change(const Checkpoint &file, const std::string &name, double last_dt, std::size_t n) {
  const auto &values = file.field(name);
  return vector(last_dt > 0 || !values.empty() ? file.field(name, n) : values);
}

std::vector<double> list(const Impact &i) {
  return {i.touch_time,    i.release_time, i.direction_deg,   i.approach_speed,
          i.rebound_speed, i.peak_force,   i.peak_penetration};
}

Impact impact_from(const Checkpoint &file, const std::string &name) {
  return impact_of(file.field(name, per_impact).data());
}

void begin_checkpoint(const RunOptions &options, const RunRecord &record) {
  if (!options.keeps_files()) return;
  Checkpoint file;
  file.texts["identity"] = json_text(record.identity);
  write_checkpoint(file, checkpoint_of(options));
}

Checkpoint kept_checkpoint(const RunOptions &options, const RunRecord &record) {
  Checkpoint file = read_checkpoint(checkpoint_of(options));
  const auto kept = identity_from(nlohmann::json::parse(file.text("identity"), nullptr, false)),
             now = identity_from(record.identity);
  if (!kept || !now) file.damaged("it does not say what it is of");
  if (*kept != *now) {
    const std::string what = changes(*kept, *now);
    throw DataError(fmt::format("{} belongs to another run: {} since; run without --resume to start afresh", file.path,
                                what.empty() ? "the files it reads changed" : what));
  }
  return file;
}

bool has_only_begun(const Checkpoint &file) {
  return file.numbers.empty();
}

void put(Checkpoint &file, const RunRecord &record) {
  file.texts["identity"] = json_text(record.identity);
  file.texts["warnings"] = "";
  for (const auto &warning : record.warnings) file.texts["warnings"] += warning + "\n";
  file.numbers["ended"] = {double(record.ended)};
  for (const LedgerEntry entry : ledger_entries) file.numbers["ledger"].push_back(record.ledger.*entry);
  auto &impacts = file.numbers["impacts"];
  for (const auto &impact : record.impacts)
    for (const double value : list(impact)) impacts.push_back(value);
  file.numbers["counts"] = {double(record.n_steps), double(record.n_cuts), double(record.augmentation_caps)};
  const SolverWork all = record.work_so_far(), &rows = record.rows_work;
  for (const SolverWork &w : {all, rows})
    for (const auto &count : solver_counts) file.numbers["work"].push_back(double(w.*count.of));
  file.texts["signals"] = "";
  for (const auto &[name, values] : record.response.all()) {
    file.numbers["response_" + name] = values;
    file.texts["signals"] += name + "\n";
  }
  file.numbers["seconds_wall"] = {record.wall_so_far()};
  file.numbers["processor_seconds"] = {record.processor_so_far() * ranks().size}; // ranks are alike: they wait busily
  for (const auto &[name, seconds] : record.split_so_far()) file.numbers["seconds_" + name] = {seconds};
  for (const auto &[time, name] : record.fields) file.numbers["field_" + name.substr(name.find('/') + 1)] = {time};
}

void get(const Checkpoint &file, RunRecord &record) {
  record.ended = file.number("ended", flag) != 0;
  std::istringstream lines(file.text("warnings"));
  for (std::string line; std::getline(lines, line);) record.warnings.push_back(line);
  const auto &ledger = file.field("ledger", std::size(ledger_entries));
  for (std::size_t k = 0; k < std::size(ledger_entries); ++k) record.ledger.*ledger_entries[k] = ledger[k];
  const auto &impacts = file.field("impacts");
  if (impacts.size() % per_impact != 0)
    file.damaged(fmt::format("field impacts has {} values, {} an impact are due", impacts.size(), per_impact));
  for (std::size_t k = 0; k < impacts.size(); k += per_impact) record.impacts.push_back(impact_of(&impacts[k]));
  const auto &w = file.field("work", 2 * std::size(solver_counts), count);
  for (std::size_t k = 0; k < std::size(solver_counts); ++k) {
    record.earlier_work.*solver_counts[k].of = std::lround(w[k]);
    record.rows_work.*solver_counts[k].of = std::lround(w[k + std::size(solver_counts)]);
  }
  const auto &n = file.field("counts", 3, count);
  record.n_steps = n[0], record.n_cuts = n[1], record.augmentation_caps = n[2];
  get_response(file, record);
  record.earlier_wall = file.number("seconds_wall", seconds);
  record.earlier_processor = file.number("processor_seconds", seconds) / ranks().size;
  for (const auto &[name, values] : file.numbers) {
    if (name.starts_with("seconds_") && name != "seconds_wall")
      record.time_split[name.substr(8)] = file.number(name, seconds);
    if (name.starts_with("field_")) record.fields.emplace_back(file.number(name), "fields/" + name.substr(6));
  }
}

} // namespace rimpact::fe

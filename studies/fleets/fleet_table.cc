#include "studies/fleets/fleet_table.h"
#include "io/files/error.h"
#include "io/files/table_csv.h"
#include "io/files/table_hdf5.h"
#include "responses/open_impact.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <regex>

namespace rimpact::fleets {
namespace {

/// Columns every fleet has, in this order; what models add stands behind them.
const std::vector<std::string> &result_columns() {
  static const std::vector<std::string> names = {"status",
                                                 "peak_displacement_m",
                                                 "peak_lateral_force_N",
                                                 "peak_impact_force_N",
                                                 "n_impacts",
                                                 "first_touch_s",
                                                 "first_approach_speed_m_s",
                                                 "first_rebound_speed_m_s",
                                                 "residual_displacement_m",
                                                 "peak_vertical_displacement_m",
                                                 "min_normal_force_N",
                                                 "energy_imbalance_relative",
                                                 "beyond_rim",
                                                 "beyond_fit",
                                                 "hits_beyond_fit",
                                                 "hits_beyond_pair",
                                                 "hits_beyond_rim",
                                                 "hits_beyond_steel",
                                                 "slowest_approach_speed_m_s",
                                                 "fastest_approach_speed_m_s",
                                                 "known_from_m_s",
                                                 "known_to_m_s",
                                                 "n_steps",
                                                 "wall_time_s",
                                                 "reason"};
  return names;
}

void add(Row &row, const std::string &name, double value) {
  if (std::isfinite(value)) {
    row[name] = value;
    return;
  }
  row["status"] = word(RowStatus::failed);
  row["reason"] = name + " came out not finite";
}

} // namespace

Row row_of(const Summary &s) {
  Row row{{"status", word(s.status)}, {"reason", s.reason}};
  add(row, "peak_displacement_m", s.peak_displacement);
  add(row, "peak_lateral_force_N", s.peak_lateral_force);
  if (s.peak_impact_force) add(row, "peak_impact_force_N", *s.peak_impact_force);
  add(row, "n_impacts", static_cast<double>(s.impacts.size()));
  if (!s.impacts.empty()) {
    add(row, "first_touch_s", s.impacts.front().touch_time);
    add(row, "first_approach_speed_m_s", s.impacts.front().approach_speed);
    if (!is_open(s.impacts.front())) add(row, "first_rebound_speed_m_s", s.impacts.front().rebound_speed);
  }
  add(row, "residual_displacement_m", s.residual_displacement);
  add(row, "peak_vertical_displacement_m", s.peak_vertical_displacement);
  if (s.min_normal_force) add(row, "min_normal_force_N", *s.min_normal_force);
  if (s.energy) add(row, "energy_imbalance_relative", s.energy->imbalance_relative());
  add(row, "n_steps", static_cast<double>(s.n_steps));
  add(row, "wall_time_s", s.wall_time);
  for (const auto &[name, value] : s.extra.items()) {
    if (value.is_number()) add(row, name, value.get<double>());
    if (value.is_boolean()) add(row, name, value.get<bool>() ? 1 : 0);
  }
  const auto hits = s.extra.value("hit_limits", nlohmann::json::object());
  for (const auto &[name, value] : hits.items())
    if (value.is_number()) add(row, name, value.get<double>()); // null: not known, an empty cell
  return row;
}

std::optional<double> number_in(const Row &row, const std::string &column) {
  const auto found = row.find(column);
  const auto *value = found == row.end() ? nullptr : std::get_if<double>(&found->second);
  return value ? std::optional(*value) : std::nullopt;
}

bool is_true(const Row &row, const std::string &column) {
  return number_in(row, column).value_or(0) != 0;
}

Row row_without_result(RowStatus status, const std::string &reason) {
  return {{"status", word(status)}, {"reason", reason}};
}

FleetTable::FleetTable(const Sweep &sweep, std::map<std::string, std::string> meta)
    : sweep_(sweep), meta_(std::move(meta)) {}

void FleetTable::read_folder(const std::string &folder) {
  for (const auto &entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    static const std::regex ours("table(-[0-9]+-of-[0-9]+)?\\.csv"); // other tables are the user's
    if (std::regex_match(name, ours)) read(entry.path().string());
  }
}

void FleetTable::read(const std::string &path) {
  const Table table = read_table(path);
  const auto is_parameter = [&](const std::string &name) {
    return std::find(sweep_.keys.begin(), sweep_.keys.end(), name) != sweep_.keys.end();
  };
  if (table.columns.empty() || table.columns[0] != "run")
    throw DataError(fmt::format("{}: its first column is not \"run\"", path));
  for (const auto &cells : table.rows) {
    const auto *run = std::get_if<double>(&cells[0]);
    if (!run || *run < 1 || *run > static_cast<double>(sweep_.runs.size()) || *run != std::floor(*run))
      throw DataError(fmt::format("{}: a run's number is not from 1 to {}", path, sweep_.runs.size()));
    Row row;
    for (std::size_t i = 1; i < cells.size(); ++i)
      if (!is_parameter(table.columns[i]) && cells[i].index() != 0) row[table.columns[i]] = cells[i];
    const auto status = row.find("status");
    if (status == row.end() || !std::get_if<std::string>(&status->second))
      throw DataError(fmt::format("{}: run {:.0f} has no status", path, *run));
    set(static_cast<std::size_t>(*run) - 1, std::move(row));
  }
}

Table FleetTable::table(const std::vector<std::size_t> &wanted) const {
  Table table;
  table.meta = meta_;
  std::vector<std::string> results = result_columns();
  for (const auto run : wanted)
    if (has(run))
      for (const auto &[name, cell] : row(run))
        if (std::find(results.begin(), results.end(), name) == results.end()) results.push_back(name);
  std::sort(results.begin() + static_cast<std::ptrdiff_t>(result_columns().size()), results.end());
  table.columns = {"run"};
  table.columns.insert(table.columns.end(), sweep_.keys.begin(), sweep_.keys.end());
  table.columns.insert(table.columns.end(), results.begin(), results.end());
  for (const auto run : wanted) {
    if (!has(run)) continue;
    std::vector<Cell> cells{static_cast<double>(run + 1)};
    for (const auto &value : sweep_.runs[run]) cells.push_back(value.cell);
    for (const auto &name : results) {
      const auto found = row(run).find(name);
      cells.push_back(found == row(run).end() ? Cell{} : found->second);
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

void FleetTable::keep(const std::string &path, const std::vector<std::size_t> &wanted) const {
  write_csv(table(wanted), path + ".csv");
}

void FleetTable::write(const std::string &path, const std::vector<std::size_t> &wanted) const {
  const Table all = table(wanted);
  write_hdf5(all, path + ".h5");
  write_csv(all, path + ".csv"); // last: it is what a later call goes on from
}

} // namespace rimpact::fleets

#include "studies/fleets/fractiles.h"
#include "studies/fleets/hit_shares.h"
#include "studies/fleets/run_end.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace rimpact::fleets {
namespace {

constexpr double beyond = std::numeric_limits<double>::infinity(); ///< where a stopped run stands
const char *const quantities[] = {"peak_displacement_m", "peak_lateral_force_N", "peak_impact_force_N", "peak_drift_m",
                                  "ductility"};
const std::pair<const char *, double> shares[] = {{"p16_", 0.16}, {"p50_", 0.50}, {"p84_", 0.84}};

struct Level {
  int n_runs = 0, n_stopped = 0, n_with_impact = 0, n_without_result = 0;
  std::optional<int> n_beyond_rim, n_beyond_fit; ///< none: of no run is it known
  HitShares hits;
  std::vector<double> values[std::size(quantities)];
};

std::size_t column(const Table &table, const std::string &name) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), name);
  if (found == table.columns.end()) throw std::logic_error("a table without the column " + name);
  return static_cast<std::size_t>(found - table.columns.begin());
}

bool has(const Table &table, const std::string &name) {
  return std::find(table.columns.begin(), table.columns.end(), name) != table.columns.end();
}

template <class Number> Cell cell(const std::optional<Number> &value) {
  return value ? Cell(static_cast<double>(*value)) : Cell();
}

Cell fractile(std::vector<double> values, double share) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + (place > static_cast<double>(below)), values.size() - 1);
  if (values[above] == beyond) return {};
  return std::lerp(values[below], values[above], place - static_cast<double>(below));
}

void add(Level &level, const Table &runs, const std::vector<Cell> &row) {
  const auto number = [&](const std::string &name) { return std::get_if<double>(&row[column(runs, name)]); };
  const auto text = [&](const char *name) {
    const auto *found = std::get_if<std::string>(&row[column(runs, name)]);
    return found ? *found : std::string();
  };
  const RunEnd end = run_end(parse<RowStatus>(text("status")), text("reason"));
  const bool stopped = end == RunEnd::beyond;
  if (end == RunEnd::without_result) {
    ++level.n_without_result;
    return;
  }
  ++level.n_runs;
  level.n_stopped += stopped;
  if (const auto *n = number("n_impacts")) level.n_with_impact += *n > 0;
  for (const auto &[name, count] : {std::pair{"beyond_rim", &level.n_beyond_rim}, {"beyond_fit", &level.n_beyond_fit}})
    if (const auto *flag = has(runs, name) ? number(name) : nullptr) // tables of before have no such column
      *count = count->value_or(0) + (*flag != 0);
  level.hits.add([&](const char *name) {
    const auto *value = has(runs, name) ? number(name) : nullptr;
    return value ? std::optional(*value) : std::nullopt;
  });
  for (std::size_t i = 0; i < std::size(quantities); ++i) {
    if (!has(runs, quantities[i])) continue;
    const auto *value = number(quantities[i]);
    if (stopped)
      level.values[i].push_back(beyond);
    else if (value)
      level.values[i].push_back(*value);
  }
}

} // namespace

Table fractiles(const Table &runs, const std::string &along, const std::vector<std::string> &by) {
  const std::size_t place = column(runs, along);
  std::vector<std::size_t> groups;
  for (const auto &name : by) groups.push_back(column(runs, name));
  std::map<std::vector<Cell>, Level> levels; // by the group's values, then along
  for (const auto &row : runs.rows) {
    if (!std::holds_alternative<double>(row[place]))
      throw std::logic_error("fractiles along a column that is not of numbers");
    std::vector<Cell> key;
    for (const auto group : groups) key.push_back(row[group]);
    key.push_back(row[place]);
    add(levels[key], runs, row);
  }
  Table result;
  result.columns = by;
  for (const char *name :
       {along.c_str(), "n_runs", "n_stopped", "n_with_impact", "n_beyond_rim", "n_beyond_fit", "n_without_result",
        "n_hits", "share_beyond_fit", "share_beyond_pair", "share_beyond_rim", "share_beyond_steel"})
    result.columns.emplace_back(name);
  for (const auto *quantity : quantities) {
    if (!has(runs, quantity)) continue;
    for (const auto &[prefix, share] : shares) result.columns.push_back(std::string(prefix) + quantity);
  }
  for (const auto &[key, level] : levels) {
    std::vector<Cell> row = key;
    for (const std::optional<int> count :
         {std::optional(level.n_runs), std::optional(level.n_stopped), std::optional(level.n_with_impact),
          level.n_beyond_rim, level.n_beyond_fit, std::optional(level.n_without_result)})
      row.push_back(cell(count));
    row.emplace_back(static_cast<double>(level.hits.n_hits()));
    for (const auto *part : {&level.hits.fit(), &level.hits.pair(), &level.hits.rim(), &level.hits.steel()})
      row.push_back(cell(part->share()));
    for (std::size_t i = 0; i < std::size(quantities); ++i)
      if (has(runs, quantities[i]))
        for (const auto &[prefix, share] : shares) row.push_back(fractile(level.values[i], share));
    result.rows.push_back(std::move(row));
  }
  return result;
}

} // namespace rimpact::fleets

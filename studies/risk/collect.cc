#include "studies/risk/collect.h"
#include "io/files/error.h"
#include "io/files/table.h"
#include "io/files/table_csv.h"
#include "studies/fleets/run_end.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <set>

namespace rimpact::risk {
namespace {

constexpr double absent = std::numeric_limits<double>::quiet_NaN();

/// Columns by name; a column that is not there is npos.
class Columns {
public:
  explicit Columns(const Table &table) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) places_[table.columns[i]] = i;
  }
  double number(const std::vector<Cell> &row, const std::string &name) const {
    const auto found = places_.find(name);
    const auto *value = found == places_.end() ? nullptr : std::get_if<double>(&row[found->second]);
    return value ? *value : absent;
  }
  std::string text(const std::vector<Cell> &row, const std::string &name) const {
    const auto found = places_.find(name);
    const auto *value = found == places_.end() ? nullptr : std::get_if<std::string>(&row[found->second]);
    return value ? *value : "";
  }

private:
  std::map<std::string, std::size_t> places_;
};

Response response_of(const Study &study, const Columns &columns, const std::vector<Cell> &row,
                     const std::vector<std::string> &inputs, bool beyond) {
  Response response{0, beyond, {}, {}, columns.number(row, "n_impacts") > 0};
  for (const auto &limit : study.limits) {
    // A run without an impact has no rim force in its table.
    double value = limit.quantity == collapsed ? 0 : columns.number(row, limit.quantity);
    if (std::isnan(value) && limit.quantity == "peak_impact_force_N") value = 0;
    response.values.push_back(value);
  }
  for (const auto &key : inputs) response.inputs.push_back(columns.number(row, key));
  return response;
}

/// How a run ends that leaves its rim behind, which the table's column beyond_rim says.
enum class PastRim { no, through, left_out };
PastRim past_rim(const Columns &columns, const std::vector<Cell> &row) {
  if (columns.number(row, "beyond_rim") != 1) return PastRim::no;
  return columns.number(row, "n_impacts") > 0 ? PastRim::through : PastRim::left_out;
}

/// Of a rim pressed deeper than it is thick: it has failed, and what came after is no result. Only the travel had grown
/// so far in any case.
void keep_travel_alone(const Study &study, Response &response) {
  for (std::size_t k = 0; k < study.limits.size(); ++k)
    if (study.limits[k].quantity != "peak_displacement_m") response.values[k] = absent;
}

/// The records of all levels, numbered alike for every system.
std::map<std::string, int> numbers_of(const Motions &motions, std::vector<std::string> &names) {
  std::map<std::string, int> numbers;
  for (const auto &level : motions.levels)
    for (const auto &motion : level.motions)
      if (numbers.emplace(motion.record, static_cast<int>(names.size())).second) names.push_back(motion.record);
  return numbers;
}

/// Records whose runs do not all respond as another record's.
int different_records(const ResponseLevel &level) {
  std::map<int, std::vector<std::vector<double>>> responses;
  for (const auto &run : level.runs) {
    auto &values = responses[run.record].emplace_back(run.values);
    values.push_back(run.beyond);
  }
  std::set<std::vector<std::vector<double>>> different;
  for (auto &[record, values] : responses) different.insert(std::move(values));
  return static_cast<int>(different.size());
}

void require_quantities(const Study &study, const ResponseSet &set, const std::string &path) {
  for (std::size_t k = 0; k < study.limits.size(); ++k)
    for (const auto &level : set.levels)
      for (const auto &run : level.runs)
        if (!run.beyond && std::isnan(run.values[k]))
          throw InputError(fmt::format("{}: limit.quantity \"{}\" is not among the results of this scene's runs ({})",
                                       study.origin, study.limits[k].quantity, path));
}

/// The run of a row, into its level.
void add_run(const Study &study, const Columns &columns, const std::vector<Cell> &row, int record, ResponseSet &set,
             ResponseLevel &level) {
  const auto end = fleets::run_end(parse<fleets::RowStatus>(columns.text(row, "status")), columns.text(row, "reason"));
  Response response = response_of(study, columns, row, set.inputs, end == fleets::RunEnd::beyond);
  response.record = record;
  const PastRim past = end == fleets::RunEnd::done ? past_rim(columns, row) : PastRim::no;
  set.n_past_wall += past == PastRim::left_out, set.n_through_rim += past == PastRim::through;
  if (past == PastRim::through) keep_travel_alone(study, response);
  const bool unfinished = end == fleets::RunEnd::without_result || past == PastRim::through;
  (unfinished ? level.unfinished : level.runs).push_back(std::move(response));
}

void require_all_runs(const Study &study, const Motions &motions, std::size_t rows, const std::string &path) {
  std::size_t wanted = 0;
  for (const auto &level : motions.levels)
    wanted += level.motions.size() * static_cast<std::size_t>(std::max(1, study.parts.samples));
  if (rows != wanted) throw DataError(fmt::format("{}: {} rows, the study has {} runs a system", path, rows, wanted));
}

} // namespace

ResponseSet collect(const Study &study, const std::string &folder, const Motions &motions) {
  const std::string path = folder + "/table.csv";
  const Table table = read_table(path);
  const Columns columns(table);
  ResponseSet set;
  set.implausible = fleets::ImplausibleRuns(study.parts.plausible);
  set.runs = shape_of(table);
  for (const auto &key : study.parts.sampled) set.inputs.push_back(key.key);
  std::map<double, ResponseLevel> levels;
  const auto records = numbers_of(motions, set.records);
  for (const auto &row : table.rows) {
    const double intensity = columns.number(row, "variable.level_g");
    const std::string record = columns.text(row, "record");
    if (std::isnan(intensity) || record.empty())
      throw DataError(path + ": a row has no record or no variable.level_g; is it of another version?");
    ResponseLevel &level = levels[intensity];
    level.intensity_g = intensity;
    const fleets::CellReader cells = [&](const char *name) {
      const double value = columns.number(row, name);
      return std::isnan(value) ? std::nullopt : std::optional(value);
    };
    level.hits.add(cells), set.implausible.add(cells);
    const auto known = records.find(record);
    if (known == records.end()) throw DataError(fmt::format("{}: {} is no record of this study", path, record));
    add_run(study, columns, row, known->second, set, level);
  }
  require_all_runs(study, motions, table.rows.size(), path);
  for (auto &[intensity, level] : levels) {
    level.n_records = different_records(level);
    if (!level.runs.empty()) set.levels.push_back(std::move(level));
  }
  if (set.levels.empty()) throw DataError(path + ": no run has a result; its columns status and reason say why");
  require_quantities(study, set, path);
  return set;
}

} // namespace rimpact::risk

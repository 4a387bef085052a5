#include "calibration/data/channels.h"
#include "calibration/data/measured_table.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/text.h"
#include "responses/response_csv.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>

namespace rimpact::calibration {
namespace {

/// "m/s" is written m_per_s in names of columns.
std::string base_of(const std::string &units) {
  return units == "m/s" ? "m_per_s" : units;
}

/// Where the table of that name lies; the column of its clock is named first.
TableForm form_of(const Mapping &mapping, const std::string &file, int block) {
  const bool own = file == mapping.file;
  TableForm form{mapping.encoding, own ? mapping.skip_lines : 0, own ? block : 0, {}};
  if (own) form.names.push_back(mapping.column_of("time")->header);
  for (const auto &column : mapping.columns) {
    if (column.signal == "time" || column.table(mapping) != file) continue;
    if (!column.time_column.empty()) form.names.push_back(column.time_column);
    form.names.push_back(column.header);
  }
  if (own && !mapping.test_column.empty()) form.names.push_back(mapping.test_column);
  std::sort(form.names.begin() + 1, form.names.end());
  form.names.erase(std::unique(form.names.begin() + 1, form.names.end()), form.names.end());
  return form;
}

void require_signal(const Mapping &mapping, const char *signal) {
  if (!mapping.column_of(signal)) throw DataError(fmt::format("{}: {} has no column", mapping.path, signal));
}

class ChannelReader {
public:
  ChannelReader(const Mapping &mapping, const TestPart &part) : mapping_(mapping), part_(part) {}
  Channels read();

private:
  const MeasuredTable &table_of(const std::string &file);
  std::vector<std::size_t> rows_of(const MeasuredTable &table) const;
  void require_columns(const MeasuredTable &table, const Column &column) const;
  double scale_of(const Column &column, const MeasuredTable &table, std::string &unit) const;
  std::vector<double> values(const Column &column, const MeasuredTable &table, const std::vector<std::size_t> &rows);
  void add_own_clocks();
  void cut(double from, double to);
  const MeasuredTable &main() { return table_of(mapping_.file); }
  const Column &time() const { return *mapping_.column_of("time"); }

  const Mapping &mapping_;
  const TestPart &part_;
  std::map<std::string, MeasuredTable> tables_;
  double time_scale_ = 1;
  Channels channels_;
};

const MeasuredTable &ChannelReader::table_of(const std::string &file) {
  if (const auto known = tables_.find(file); known != tables_.end()) return known->second;
  const std::string path = (std::filesystem::path(mapping_.path).parent_path() / file).string();
  const auto &table =
      tables_.emplace(file, MeasuredTable(read_file(path), path, form_of(mapping_, file, part_.block))).first->second;
  for (const auto &column : mapping_.columns)
    if (column.table(mapping_) == file) require_columns(table, column);
  if (file == mapping_.file && !mapping_.test_column.empty())
    require_columns(
        table, {.signal = "test_column", .header = mapping_.test_column, .unit = {}, .time_column = {}, .file = {}});
  return table;
}

void ChannelReader::require_columns(const MeasuredTable &table, const Column &column) const {
  for (const auto &name : {column.header, column.time_column})
    if (!name.empty() && !table.has(name))
      throw DataError(
          fmt::format("{}: no column \"{}\" ({}); the header{} names \"{}\"", table.path(), name, column.signal,
                      mapping_.skip_lines > 0 ? fmt::format(", after skip_lines = {},", mapping_.skip_lines) : "",
                      fmt::join(table.header(), "\", \"")));
}

/// Of the main table; every other has the rows of its own clock.
std::vector<std::size_t> ChannelReader::rows_of(const MeasuredTable &table) const {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < table.size(); ++i)
    if (mapping_.test_column.empty() || !table.has(mapping_.test_column) ||
        table.text(i, mapping_.test_column) == part_.name)
      rows.push_back(i);
  if (rows.empty())
    throw DataError(
        fmt::format("{}: no row is of the test {} (column \"{}\")", table.path(), part_.name, mapping_.test_column));
  return rows;
}

/// From the declared unit, else that of the table; both, where there are both, must be one.
double ChannelReader::scale_of(const Column &column, const MeasuredTable &table, std::string &unit) const {
  const auto info = std::find_if(known_signals().begin(), known_signals().end(),
                                 [&](const auto &s) { return s.name == column.signal; });
  const std::string found = table.unit(column.header);
  unit = column.unit.empty() ? found : column.unit;
  const std::string names = csv_units_of(base_of(info->units)),
                    choices = names.empty() ? "no unit that a table may state" : names;
  if (unit.empty())
    throw InputError(fmt::format("{}: columns.{}.unit is missing, and {} has neither a row of units nor one in the "
                                 "name's brackets; it may be given in {}",
                                 mapping_.path, column.signal, table.path(), choices));
  const auto known = csv_unit(unit);
  if (!known || base_of(info->units) != known->base)
    throw InputError(fmt::format(
        "{}: columns.{}.unit \"{}\" is no unit of {}; it is stored in {}, and may be given in {}; `factor` turns "
        "any other unit into one of these",
        mapping_.path, column.signal, unit, info->name, info->units, choices));
  if (const auto there = csv_unit(found); there && there->factor != known->factor && column.factor == 1)
    throw DataError(fmt::format("{}: column \"{}\" is in {} by the table itself, in {} by {} (columns.{}.unit)",
                                table.path(), column.header, found, column.unit, mapping_.path, column.signal));
  return known->factor;
}

std::vector<double> ChannelReader::values(const Column &column, const MeasuredTable &table,
                                          const std::vector<std::size_t> &rows) {
  std::string unit;
  const double scale = scale_of(column, table, unit);
  if (column.signal.starts_with("impact_")) channels_.unit_of_force = unit;
  if (column.signal == "time") time_scale_ = scale;
  std::vector<double> all;
  all.reserve(rows.size());
  for (const auto row : rows) all.push_back((table.number(row, column.header) - column.zero) * column.factor * scale);
  return all;
}

void require_rising(const std::vector<double> &time, const std::string &table, const std::string &what) {
  for (std::size_t i = 1; i < time.size(); ++i)
    if (time[i] <= time[i - 1])
      throw DataError(
          fmt::format("{}: {} runs from {:g} s to {:g} s at sample {}{}", table, what, time[i - 1], time[i], i + 1,
                      time[i] < time[i - 1] ? "; where several tests stand in the table, say which rows are "
                                              "one: test_column, from_s and to_s, or block"
                                            : ""));
}

void ChannelReader::cut(double from, double to) {
  const auto times = channels_.response.series("time");
  const auto first = std::lower_bound(times.begin(), times.end(), from) - times.begin(),
             end = std::upper_bound(times.begin(), times.end(), to) - times.begin();
  if (end - first < 2)
    throw DataError(fmt::format("{}: {} sample{} from {:g} s to {:g} s; the table has {:g} s to {:g} s",
                                tables_.at(mapping_.file).path(), std::max<std::ptrdiff_t>(0, end - first),
                                end - first == 1 ? "" : "s", from, to, times.front(), times.back()));
  Response kept;
  for (const auto &[name, series] : channels_.response.all())
    kept.series(name) = std::vector<double>(series.begin() + first, series.begin() + end);
  channels_.response = std::move(kept);
}

/// All of them have the instants that every one covers.
void ChannelReader::add_own_clocks() {
  struct Own {
    const Column *column;
    std::vector<double> times, values;
  };
  std::vector<Own> all;
  double from = -unbounded, to = unbounded;
  for (const auto &column : mapping_.columns) {
    if (!column.own_clock()) continue;
    const auto &table = table_of(column.table(mapping_));
    const auto &clock = column.time_column.empty() ? time().header : column.time_column;
    std::vector<std::size_t> rows;
    for (const auto row : rows_of(table))
      if (!trim(table.text(row, clock)).empty()) rows.push_back(row);
    Own own{&column, {}, values(column, table, rows)};
    for (const auto row : rows)
      own.times.push_back((table.number(row, clock) - time().zero) * time().factor * time_scale_ - column.lag);
    require_rising(own.times, table.path(), fmt::format("the clock of {}", column.signal));
    from = std::max(from, own.times.front()), to = std::min(to, own.times.back());
    all.push_back(std::move(own));
  }
  if (all.empty()) return;
  cut(from, to);
  const auto at = channels_.response.series("time");
  for (const auto &own : all) {
    channels_.response.series(own.column->signal) = on_clock(own.times, own.values, at);
    channels_.notes.push_back(
        fmt::format("{} has a clock of its own ({} samples{}): it is taken at the {} instants of "
                    "time that it covers",
                    own.column->signal, own.times.size(),
                    own.column->lag == 0 ? "" : fmt::format(", {:g} ms late", 1e3 * own.column->lag), at.size()));
  }
}

Channels ChannelReader::read() {
  require_signal(mapping_, "time");
  main(); // a column that the table has not comes before one that the mapping has not
  require_signal(mapping_, "displacement_x");
  if (!mapping_.column_of("impact_x") && !mapping_.column_of("impact_y"))
    throw DataError(mapping_.path + ": neither impact_x nor impact_y, the rim's force, has a column");
  auto rows = rows_of(main());
  const bool clocks = std::any_of(mapping_.columns.begin(), mapping_.columns.end(),
                                  [](const Column &c) { return c.own_clock() && c.file.empty(); });
  if (clocks) std::erase_if(rows, [&](std::size_t row) { return trim(main().text(row, time().header)).empty(); });
  channels_.response.series("time") = values(time(), main(), rows);
  require_rising(channels_.response.series("time"), main().path(), "time");
  for (const auto &column : mapping_.columns)
    if (!column.own_clock() && column.signal != "time")
      channels_.response.series(column.signal) = values(column, main(), rows);
  if (part_.from_time || part_.to_time) cut(part_.from_time.value_or(-unbounded), part_.to_time.value_or(unbounded));
  add_own_clocks();
  for (const auto &[file, table] : tables_)
    for (const auto &note : table.notes()) channels_.notes.push_back(note);
  return std::move(channels_);
}

} // namespace

std::vector<double> on_clock(const std::vector<double> &times, const std::vector<double> &values,
                             const std::vector<double> &at) {
  std::vector<double> all;
  all.reserve(at.size());
  for (const double t : at) {
    const auto above = std::clamp<std::ptrdiff_t>(std::upper_bound(times.begin(), times.end(), t) - times.begin(), 1,
                                                  static_cast<std::ptrdiff_t>(times.size()) - 1);
    const auto i = static_cast<std::size_t>(above);
    const double share = (t - times[i - 1]) / (times[i] - times[i - 1]);
    all.push_back(values[i - 1] + share * (values[i] - values[i - 1]));
  }
  return all;
}

Channels read_channels(const Mapping &mapping, const TestPart &part) {
  return ChannelReader(mapping, part).read();
}

std::vector<std::string> tests_of(const Mapping &mapping) {
  std::vector<std::string> names;
  for (const auto &test : mapping.tests) names.push_back(test.name);
  if (!names.empty() || mapping.test_column.empty()) return names;
  const std::string path = (std::filesystem::path(mapping.path).parent_path() / mapping.file).string();
  require_signal(mapping, "time");
  const MeasuredTable table(read_file(path), path, form_of(mapping, mapping.file, mapping.whole.block));
  if (!table.has(mapping.test_column))
    throw DataError(fmt::format("{}: no column \"{}\" (test_column); the header names \"{}\"", path,
                                mapping.test_column, fmt::join(table.header(), "\", \"")));
  for (std::size_t i = 0; i < table.size(); ++i)
    if (const auto &name = table.text(i, mapping.test_column);
        !name.empty() && std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  return names;
}

} // namespace rimpact::calibration

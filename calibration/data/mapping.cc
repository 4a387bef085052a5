#include "calibration/data/mapping.h"
#include "io/files/file.h"
#include "io/files/text.h"
#include "io/files/toml_reader.h"
#include "scene/file_kind.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::calibration {

namespace {

void check_column(const Column &column, const std::string &path) {
  const auto fail = [&](const char *what) {
    throw InputError(fmt::format("{}: columns.{}{}", path, column.signal, what));
  };
  if (column.header.empty()) fail(".column is missing");
  if (column.signal == "time" && (column.own_clock() || column.estimate_lag || !column.file.empty()))
    fail(": time_column, lag_ms, estimate_lag and file are of the other channels: this is the clock they are held "
         "against");
  if (!column.file.empty() && column.time_column.empty())
    fail(": file names another table, whose clock is needed: time_column");
  if (column.estimate_lag && column.signal != "impact_x" && column.signal != "impact_y")
    fail(".estimate_lag: only the rim's force, impact_x or impact_y, has a lag that its impulse tells");
  if (column.estimate_lag && column.lag != 0) fail(": lag_ms states what estimate_lag looks for; give one of them");
}

std::vector<Column> read_columns(const TomlFile &toml, const std::string &path) {
  std::vector<std::string> known;
  for (const auto &info : known_signals()) known.push_back(info.name);
  const auto *table = toml.find("columns");
  if (!table || !table->is_table()) throw InputError(path + ": the table [columns] is missing");
  std::vector<Column> columns;
  for (const auto &[key, value] : *table->as_table()) {
    Column column;
    column.signal = std::string(key.str());
    const auto info = std::find_if(known_signals().begin(), known_signals().end(),
                                   [&](const auto &s) { return s.name == column.signal; });
    if (info == known_signals().end())
      throw InputError(
          fmt::format("{}: columns.{}", toml.location("columns." + column.signal), unknown_word(column.signal, known)));
    TomlReader reader(toml, "columns." + column.signal);
    visit(reader, column);
    reader.finish();
    check_column(column, path);
    columns.push_back(column);
  }
  return columns;
}

std::vector<std::string> read_changes(const TomlFile &toml, const std::string &key) {
  std::vector<std::string> changes;
  const auto *list = toml.find(key);
  if (!list) return changes;
  const auto fail = [&] { throw InputError(toml.location(key) + ": set must be an array of KEY=VALUE strings"); };
  if (!list->is_array()) fail();
  for (const auto &item : *list->as_array()) {
    if (!item.is_string()) fail();
    changes.push_back(item.as_string()->get());
  }
  return changes;
}

/// [test.NAME], each with what holds for every test and what is its own.
void read_tests(const TomlFile &toml, Mapping &mapping) {
  const auto *all = toml.find("test");
  if (!all) return;
  if (!all->is_table()) throw InputError(toml.location("test") + ": tests are tables, as [test.7]");
  std::vector<std::pair<std::uint32_t, TestPart>> found;
  for (const auto &[key, value] : *all->as_table()) {
    TestPart part = mapping.whole;
    part.name = std::string(key.str());
    const std::string table = "test." + part.name;
    if (part.name.find_first_of(".#/") != std::string::npos || !value.is_table())
      throw InputError(fmt::format("{}: a test is a table [test.NAME], its NAME without points, # and /",
                                   toml.location_of_key(table, key)));
    TomlReader reader(toml, table);
    visit(reader, part);
    reader.finish({"set"});
    for (const auto &change : read_changes(toml, table + ".set")) part.overrides.push_back(change);
    found.emplace_back(value.source().begin.line, part);
  }
  std::stable_sort(found.begin(), found.end(), [](const auto &a, const auto &b) { return a.first < b.first; });
  for (auto &[line, part] : found) mapping.tests.push_back(std::move(part));
}

std::optional<Uncertainty> read_uncertainty(const TomlFile &toml) {
  if (!toml.find("uncertainty")) return {};
  Uncertainty u;
  TomlReader reader(toml, "uncertainty");
  visit(reader, u);
  reader.finish();
  if (toml.find("uncertainty.force") && !toml.find("uncertainty.gain")) u.gain = u.force;
  return u;
}

} // namespace

void visit(KeyVisitor &v, Mapping &mapping) {
  v.text({"scene", "of the test, built in or a file"}, mapping.scene);
  v.text({"file", "the table, beside the mapping file"}, mapping.file);
  v.text({"encoding", "of the table, as windows-1254; none: UTF-8, UTF-16, or what gives the columns' names"},
         mapping.encoding);
  v.integer({"skip_lines", "before the names of the columns; 0: the first line that has them"}, mapping.skip_lines, 0,
            10000);
  v.text({"test_column", "the column that names each row's test; none: the table is one test"}, mapping.test_column);
  v.number({"force_noise", "share of the peak below which no contact is looked for; 0: by the record's noise"},
           mapping.force_noise, si, {0, 0.5});
  visit(v, mapping.whole);
}

void visit(KeyVisitor &v, TestPart &part) {
  v.limit({"from_s", "the test begins here, by columns.time"}, part.from_time, si, {-huge, huge});
  v.limit({"to_s", "it ends here"}, part.to_time, si, {-huge, huge});
  v.integer({"block", "which of the parts that begin with the names of the columns; 0: the table has one"}, part.block,
            0, 10000);
}

void visit(KeyVisitor &v, Column &column) {
  v.text({"column", "its name in the table"}, column.header);
  v.text({"unit", "of its numbers; none: as the row of units or the name's brackets say"}, column.unit);
  v.number({"factor", "stored is (value - zero) times factor, in that unit"}, column.factor, si, {-huge, huge});
  v.number({"zero", "the reading where the signal is nil"}, column.zero, si, {-huge, huge});
  v.text({"time_column", "of a channel with its own clock: the column of its instants, in the unit of time"},
         column.time_column);
  v.text({"file", "of a channel with its own clock: the table it stands in"}, column.file);
  v.number({"lag_ms", "by which the channel is late; taken off"}, column.lag, milli, {-1e5, 1e5});
  v.flag({"estimate_lag", "of the rim's force: its lag is found by momentum, taken off and told"}, column.estimate_lag);
}

void visit(KeyVisitor &v, Uncertainty &u) {
  const Range share{0, 1, true};
  v.number({"force", "share of the run's largest rim force"}, u.force, si, share);
  v.number({"displacement", "share of L_c"}, u.displacement, si, share);
  v.number({"speed", "share of the largest approach speed"}, u.speed, si, share);
  v.number({"gain", "of the force channel, common to all impacts; not given: as force"}, u.gain, si, {0, 1});
  v.number({"time_ms", "of the clock within one impact; 0: exact"}, u.time, milli, {0, 1e3});
}

const std::string &Column::table(const Mapping &mapping) const {
  return file.empty() ? mapping.file : file;
}

const Column *Mapping::column_of(const std::string &signal) const {
  const auto found = std::find_if(columns.begin(), columns.end(), [&](const auto &c) { return c.signal == signal; });
  return found == columns.end() ? nullptr : &*found;
}

Mapping read_mapping(const std::string &path) {
  const TomlFile toml(read_file(path), path);
  scene::require_run(toml);
  Mapping mapping;
  mapping.path = path;
  TomlReader reader(toml, "");
  visit(reader, mapping);
  reader.finish({"columns", "uncertainty", "set", "test"});
  for (const auto &[name, value] : {std::pair{"scene", &mapping.scene}, std::pair{"file", &mapping.file}})
    if (value->empty()) throw InputError(fmt::format("{}: {} is missing", path, name));
  mapping.whole.overrides = read_changes(toml, "set");
  read_tests(toml, mapping);
  mapping.columns = read_columns(toml, path);
  mapping.uncertainty = read_uncertainty(toml);
  return mapping;
}

} // namespace rimpact::calibration

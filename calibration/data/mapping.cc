#include "calibration/data/mapping.h"
#include "files/file.h"
#include "files/text.h"
#include "files/toml_reader.h"
#include "responses/response_files.h"
#include "scene/file_kind.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::calibration {

namespace {

/// "m/s" is written m_per_s in names of columns.
std::string base_of(const std::string &units) {
  return units == "m/s" ? "m_per_s" : units;
}

/// The names a column of this signal may state.
std::string units_of(const SignalInfo &info) {
  const std::string names = csv_units_of(base_of(info.units));
  return names.empty() ? "no unit that a table may state" : names;
}

void check_unit(Column &column, const SignalInfo &info, const std::string &path) {
  const auto unit = csv_unit(column.unit);
  if (unit && base_of(info.units) == unit->base) {
    column.si = unit->factor;
    return;
  }
  throw InputError(fmt::format(
      "{}: columns.{}.unit \"{}\" is no unit of {}; it is stored in {}, and may be given in {}; `factor` turns "
      "any other unit into one of these",
      path, column.signal, column.unit, info.name, info.units, units_of(info)));
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
          fmt::format("{}: columns.{}", toml.location("columns." + column.signal), not_among(column.signal, known)));
    TomlReader reader(toml, "columns." + column.signal);
    visit(reader, column);
    reader.finish();
    if (column.header.empty()) throw InputError(fmt::format("{}: columns.{}.column is missing", path, column.signal));
    check_unit(column, *info, path);
    columns.push_back(column);
  }
  return columns;
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
  v.integer({"skip_lines", "before the names of the columns"}, mapping.skip_lines, 0, 10000);
  v.number({"force_noise", "share of the peak below which no contact is looked for; 0: by the record's noise"},
           mapping.force_noise, si, {0, 0.5});
}

void visit(KeyVisitor &v, Column &column) {
  v.text({"column", "its name in the table"}, column.header);
  v.text({"unit", "of its numbers"}, column.unit);
  v.number({"factor", "stored is (value - zero) times factor, in that unit"}, column.factor, si, {-huge, huge});
  v.number({"zero", "the reading where the signal is nil"}, column.zero, si, {-huge, huge});
}

void visit(KeyVisitor &v, Uncertainty &u) {
  const Range share{0, 1, true};
  v.number({"force", "share of the run's largest rim force"}, u.force, si, share);
  v.number({"displacement", "share of L_c"}, u.displacement, si, share);
  v.number({"speed", "share of the largest approach speed"}, u.speed, si, share);
  v.number({"gain", "of the force channel, common to all impacts; not given: as force"}, u.gain, si, {0, 1});
  v.number({"time_ms", "of the clock within one impact; 0: exact"}, u.time, milli, {0, 1e3});
}

bool is_mapping(const std::string &path) {
  return std::filesystem::path(path).extension() == ".toml" && !std::filesystem::is_directory(path);
}

Mapping read_mapping(const std::string &path) {
  const TomlFile toml(read_file(path), path);
  scene::require_run(toml);
  Mapping mapping;
  TomlReader reader(toml, "");
  visit(reader, mapping);
  reader.finish({"columns", "uncertainty", "set"});
  for (const auto &[name, value] : {std::pair{"scene", &mapping.scene}, std::pair{"file", &mapping.file}})
    if (value->empty()) throw InputError(fmt::format("{}: {} is missing", path, name));
  if (const auto *list = toml.find("set")) {
    const auto *array = list->as_array();
    if (!array) throw InputError(toml.location("set") + ": set must be an array of KEY=VALUE strings");
    for (const auto &item : *array)
      if (const auto *text = item.as_string())
        mapping.overrides.push_back(text->get());
      else
        throw InputError(toml.location("set") + ": set must be an array of KEY=VALUE strings");
  }
  mapping.columns = read_columns(toml, path);
  mapping.uncertainty = read_uncertainty(toml);
  return mapping;
}

} // namespace rimpact::calibration

/// CSV: time_s,ux_m,uy_m,uz_m,Fx_N,Fy_N,Fz_N,Ix_N,Iy_N,gap_m. The reader also takes files of laboratories:
/// columns in any order, more columns, what loose_cells.h reads, units of csv_unit() in the names, comment lines (#); a
/// planar test may leave out uy and Fy, which are then zero. velocities (vx_m_per_s, ...) are read when
/// there.
#include "responses/response_csv.h"

#include "io/files/binary_kind.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/loose_cells.h"
#include "io/files/text.h"
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <iterator>

namespace rimpact {
namespace {

constexpr std::array columns{
    CsvColumn{"time", "s", "time", true},
    CsvColumn{"ux", "m", "displacement_x", true},
    CsvColumn{"uy", "m", "displacement_y", true},
    CsvColumn{"uz", "m", "displacement_z", true},
    CsvColumn{"Fx", "N", "force_x", true},
    CsvColumn{"Fy", "N", "force_y", true},
    CsvColumn{"Fz", "N", "force_z", true},
    CsvColumn{"Ix", "N", "impact_x", true},
    CsvColumn{"Iy", "N", "impact_y", true},
    CsvColumn{"gap", "m", "gap", true},
    CsvColumn{"vx", "m_per_s", "velocity_x", false},
    CsvColumn{"vy", "m_per_s", "velocity_y", false},
    CsvColumn{"vz", "m_per_s", "velocity_z", false},
};
constexpr double kgf = 9.80665, lbf = 4.4482216152605, inch = 0.0254; // exact, by definition
constexpr std::array unit_names{
    CsvUnit{"s", "s", 1},
    CsvUnit{"ms", "s", 1e-3},
    CsvUnit{"m", "m", 1},
    CsvUnit{"cm", "m", 1e-2},
    CsvUnit{"mm", "m", 1e-3},
    CsvUnit{"in", "m", inch},
    CsvUnit{"N", "N", 1},
    CsvUnit{"kN", "N", 1e3},
    CsvUnit{"MN", "N", 1e6},
    CsvUnit{"kgf", "N", kgf},
    CsvUnit{"tf", "N", 1e3 * kgf},
    CsvUnit{"lbf", "N", lbf},
    CsvUnit{"kip", "N", 1e3 * lbf},
    CsvUnit{"m_per_s", "m_per_s", 1},
    CsvUnit{"mm_per_s", "m_per_s", 1e-3},
    CsvUnit{"in_per_s", "m_per_s", inch},
};

/// Where the values of a column go, times `factor`; no signal: a column of no interest.
struct CsvTarget {
  std::string signal;
  double factor = 1;
};
using CsvColumns = std::function<CsvTarget(std::string_view header)>;

CsvTarget target_of(std::string_view header, const std::string &path) {
  for (const auto &column : columns) {
    const std::string prefix = std::string(column.symbol) + "_";
    if (header == column.symbol)
      throw DataError(
          fmt::format("{}: column \"{}\" needs its unit, e.g. {}_{}", path, header, column.symbol, column.unit));
    if (header.substr(0, prefix.size()) != prefix) continue;
    const auto unit = header.substr(prefix.size());
    if (const auto known = csv_unit(unit); known && std::string_view(known->base) == column.unit)
      return {column.signal, known->factor};
    throw DataError(fmt::format("{}: column \"{}\": the unit is not known; use {}_{}, or another of {}", path,
                                header.substr(0, 80), column.symbol, column.unit, csv_units_of(column.unit)));
  }
  return {};
}

std::vector<CsvTarget> read_header(std::string_view header, char separator, const CsvColumns &columns_of,
                                   Response &response, const std::string &path) {
  std::vector<CsvTarget> targets;
  for (const auto &cell : cells_of(header, separator)) {
    const CsvTarget target = columns_of(cell);
    if (!target.signal.empty() && response.has(target.signal))
      throw DataError(fmt::format("{}: column \"{}\" stands twice", path, cell));
    if (!target.signal.empty()) response.series(target.signal);
    targets.push_back(target);
  }
  return targets;
}

/// The columns `columns_of` asks for, from a table with one header line. Throws DataError naming file, line and what
/// stands there.
Response parse_columns(const std::string &bytes, const std::string &path, const CsvColumns &columns_of) {
  refuse_binary(bytes, path);
  const std::string text = utf8_text(bytes, path);
  Response response;
  std::vector<CsvTarget> targets;
  std::optional<char> stated;
  char separator = ',';
  DecimalReader decimals;
  std::size_t line_number = 0;
  for (const auto line : lines_of(text)) {
    ++line_number;
    if (trim(line).empty() || trim(line).front() == '#') continue;
    if (targets.empty()) {
      if (const auto said = stated_separator(line); said && !stated) {
        stated = said;
        continue;
      }
      separator = stated.value_or(separator_of(line));
      targets = read_header(line, separator, columns_of, response, path);
      continue;
    }
    const auto cells = cells_of(line, separator);
    const auto place = fmt::format("{}:{}", path, line_number);
    if (cells.size() < targets.size())
      throw DataError(fmt::format("{}: {} of {} columns", place, cells.size(), targets.size()));
    for (std::size_t i = 0; i < targets.size(); ++i) {
      if (targets[i].signal.empty()) continue;
      const auto value = decimals.number(cells[i], place);
      if (!value) throw DataError(fmt::format("{}: \"{}\" is not a finite number", place, cells[i].substr(0, 40)));
      response.append(targets[i].signal, *value * targets[i].factor);
    }
  }
  if (targets.empty()) throw DataError(fmt::format("{}: holds no header line", path));
  return response;
}

} // namespace

const std::vector<CsvColumn> &csv_columns() {
  static const std::vector<CsvColumn> all(columns.begin(), columns.end());
  return all;
}

std::string csv_units_of(std::string_view base) {
  std::string names;
  for (const auto &unit : unit_names)
    if (unit.base == base) names += (names.empty() ? "" : ", ") + std::string(unit.name);
  return names;
}

std::optional<CsvUnit> csv_unit(std::string_view name) {
  for (const auto &known : unit_names)
    if (name == known.name) return known;
  return {};
}

Response parse_csv(const std::string &text, const std::string &path) {
  std::vector<std::string> headers;
  Response response = parse_columns(text, path, [&](std::string_view header) {
    headers.emplace_back(header);
    return target_of(header, path);
  });
  for (const char *needed : {"time_s", "ux_m", "Fx_N"})
    if (!response.has(target_of(needed, path).signal))
      throw DataError(
          fmt::format("{}: the column {} is missing; the header names {}", path, needed, fmt::join(headers, ", ")));
  for (const auto &signal : {std::string("displacement"), std::string("force"), std::string("impact")})
    if (response.has(signal + "_x") && !response.has(signal + "_y"))
      response.series(signal + "_y").assign(response.size(), 0.0);
  return response;
}

void write_csv(const Response &response, const std::string &path) {
  response.check();
  std::vector<const std::vector<double> *> written;
  fmt::memory_buffer out;
  auto sink = std::back_inserter(out);
  for (const auto &column : columns) {
    if (!column.written) continue;
    if (!response.has(column.signal) && response.size() > 0)
      throw std::logic_error(fmt::format("response.csv needs the signal {}", column.signal));
    fmt::format_to(sink, "{}{}_{}", written.empty() ? "" : ",", column.symbol, column.unit);
    written.push_back(response.size() > 0 ? &response.series(column.signal) : nullptr);
  }
  for (std::size_t i = 0; i < response.size(); ++i) {
    char lead = '\n';
    for (const auto *values : written) {
      out.push_back(lead);
      fmt::format_to(sink, "{}", (*values)[i]);
      lead = ',';
    }
  }
  out.push_back('\n');
  write_atomically({out.data(), out.size()}, path);
}

} // namespace rimpact

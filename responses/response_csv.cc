/// CSV: time_s,ux_m,uy_m,uz_m,Fx_N,Fy_N,Fz_N,Ix_N,Iy_N,gap_m. The reader also takes files of laboratories:
/// columns in any order, more columns, `;` or tabs, mm, cm, kN, MN, ms in the names, comment lines (#); a
/// planar test may leave out uy and Fy, which are then zero. velocities (vx_m_per_s, ...) are read when
/// there.
#include "files/error.h"
#include "files/file.h"
#include "files/text.h"
#include "responses/response_files.h"
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace rimpact {
namespace {

struct Column {
  const char *symbol, *unit, *signal;
  bool written;
};
constexpr std::array columns{
    Column{"time", "s", "time", true},
    Column{"ux", "m", "displacement_x", true},
    Column{"uy", "m", "displacement_y", true},
    Column{"uz", "m", "displacement_z", true},
    Column{"Fx", "N", "force_x", true},
    Column{"Fy", "N", "force_y", true},
    Column{"Fz", "N", "force_z", true},
    Column{"Ix", "N", "impact_x", true},
    Column{"Iy", "N", "impact_y", true},
    Column{"gap", "m", "gap", true},
    Column{"vx", "m_per_s", "velocity_x", false},
    Column{"vy", "m_per_s", "velocity_y", false},
    Column{"vz", "m_per_s", "velocity_z", false},
};
constexpr std::array unit_names{
    CsvUnit{"s", "s", 1},
    CsvUnit{"ms", "s", 1e-3},
    CsvUnit{"m", "m", 1},
    CsvUnit{"cm", "m", 1e-2},
    CsvUnit{"mm", "m", 1e-3},
    CsvUnit{"N", "N", 1},
    CsvUnit{"kN", "N", 1e3},
    CsvUnit{"MN", "N", 1e6},
    CsvUnit{"m_per_s", "m_per_s", 1},
    CsvUnit{"mm_per_s", "m_per_s", 1e-3},
};

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
    throw DataError(fmt::format("{}: column \"{}\": the unit is not known; use {}_{}", path, header.substr(0, 80),
                                column.symbol, column.unit));
  }
  return {};
}

char separator_of(std::string_view header) {
  if (header.find(',') != std::string_view::npos) return ',';
  return header.find(';') != std::string_view::npos ? ';' : '\t';
}

std::vector<CsvTarget> read_header(std::string_view header, char separator, const CsvColumns &columns_of,
                                   Response &response, const std::string &path) {
  std::vector<CsvTarget> targets;
  for (auto cell : split(header, separator)) {
    cell = trim(cell);
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
    const CsvTarget target = columns_of(cell);
    if (!target.signal.empty() && response.has(target.signal))
      throw DataError(fmt::format("{}: column \"{}\" stands twice", path, cell));
    if (!target.signal.empty()) response.series(target.signal);
    targets.push_back(target);
  }
  return targets;
}

} // namespace

std::optional<CsvUnit> csv_unit(std::string_view name) {
  for (const auto &known : unit_names)
    if (name == known.name) return known;
  return {};
}

Response parse_columns(const std::string &text, const std::string &path, const CsvColumns &columns_of,
                       std::size_t skip_lines) {
  Response response;
  std::vector<CsvTarget> targets;
  char separator = ',';
  std::size_t line_number = 0;
  for (const auto line : lines_of(text)) {
    if (++line_number <= skip_lines || trim(line).empty() || trim(line).front() == '#') continue;
    if (targets.empty()) {
      separator = separator_of(line);
      targets = read_header(line, separator, columns_of, response, path);
      continue;
    }
    const auto cells = split(line, separator);
    if (cells.size() < targets.size())
      throw DataError(fmt::format("{}:{}: {} of {} columns", path, line_number, cells.size(), targets.size()));
    for (std::size_t i = 0; i < targets.size(); ++i) {
      if (targets[i].signal.empty()) continue;
      const auto value = to_number(cells[i]);
      if (!value || !std::isfinite(*value))
        throw DataError(
            fmt::format("{}:{}: \"{}\" is not a finite number", path, line_number, trim(cells[i]).substr(0, 40)));
      response.append(targets[i].signal, (*value - targets[i].zero) * targets[i].factor);
    }
  }
  if (targets.empty()) throw DataError(fmt::format("{}: holds no header line", path));
  return response;
}

Response parse_csv(const std::string &text, const std::string &path) {
  Response response = parse_columns(text, path, [&](std::string_view header) { return target_of(header, path); });
  for (const char *needed : {"time_s", "ux_m", "Fx_N"})
    if (!response.has(target_of(needed, path).signal))
      throw DataError(fmt::format("{}: the column {} is missing", path, needed));
  for (const char *other : {"displacement_y", "force_y"})
    if (!response.has(other)) response.series(other).assign(response.size(), 0.0);
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

#include "io/records/record_jma.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "io/records/direction.h"
#include "io/records/header_check.h"
#include "io/records/record.h"
#include "io/records/record_format.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact {
namespace {

constexpr std::size_t jma_preamble = 12;

/// The value of "KEY = VALUE"; empty: there is no such line.
std::string said_by_jma(const std::vector<std::string_view> &lines, std::string_view key) {
  auto rest = header_value(lines, jma_preamble, key);
  const auto value = trim(rest);
  return std::string(!value.empty() && value.front() == '=' ? trim(value.substr(1)) : value);
}

std::vector<std::string> jma_columns(std::string_view line) {
  std::vector<std::string> names;
  for (const auto cell : split(line, ',')) names.emplace_back(trim(cell));
  while (!names.empty() && names.back().empty()) names.pop_back();
  return names;
}

/// The line that names the columns, which are all directions; the number of lines: there is none.
std::size_t line_of_jma_columns(const std::vector<std::string_view> &lines) {
  for (std::size_t i = 0; i < std::min(jma_preamble, lines.size()); ++i) {
    const auto names = jma_columns(lines[i]);
    if (!names.empty() && std::all_of(names.begin(), names.end(), [](const auto &name) {
          return direction_written(name).kind != DirectionKind::unknown && !to_number(name);
        }))
      return i;
  }
  return lines.size();
}

double jma_step(const std::vector<std::string_view> &lines, const std::string &path) {
  std::string rate = upper(said_by_jma(lines, "SAMPLING RATE"));
  if (rate.ends_with("HZ")) rate.resize(rate.size() - 2);
  const auto hertz = to_number(rate);
  if (!hertz || !(*hertz >= 1 && *hertz <= 10'000))
    throw DataError(fmt::format("{}: SAMPLING RATE \"{}\" is not between 1 and 10000 Hz", path, rate.substr(0, 40)));
  return 1 / *hertz;
}

double jma_unit(const std::vector<std::string_view> &lines, const std::string &path, const ReadAs &as) {
  if (as.unit) return *as.unit;
  const std::string name = said_by_jma(lines, "UNIT"); // "gal(cm/s/s)"
  if (const auto unit = acceleration_unit(name.substr(0, name.find('(')), as.gravity)) return *unit;
  throw DataError(fmt::format("{}: UNIT \"{}\" is no unit of acceleration that is known", path, name.substr(0, 40)));
}

} // namespace

bool is_jma_table(std::string_view text) {
  const auto lines = lines_of(text.substr(0, 2000));
  return !said_by_jma(lines, "SITE CODE").empty() && !said_by_jma(lines, "SAMPLING RATE").empty() &&
         line_of_jma_columns(lines) < lines.size();
}

std::vector<Channel> channels_of_jma(std::string_view text) {
  const auto lines = lines_of(text.substr(0, 2000));
  const std::size_t header = line_of_jma_columns(lines);
  const std::size_t n = header < lines.size() ? jma_columns(lines[header]).size() : 1;
  std::vector<Channel> channels;
  for (std::size_t i = 0; i < n; ++i) channels.push_back({text, i});
  return channels;
}

RecordHead head_of_jma(const Channel &channel) {
  const auto lines = lines_of(channel.text.substr(0, 2000));
  const std::size_t header = line_of_jma_columns(lines);
  if (header >= lines.size()) return {};
  const std::string site = said_by_jma(lines, "SITE CODE");
  return {site.substr(0, site.find(',')) + " " + said_by_jma(lines, "INITIAL TIME"),
          jma_columns(lines[header])[channel.column]};
}

SampledSignal parse_jma(const std::string &text, const std::string &path, const ReadAs &as) {
  const auto lines = lines_of(text);
  const std::size_t header = line_of_jma_columns(lines);
  if (header >= lines.size()) throw DataError(path + ": no line of columns (NS, EW, UD): not a table of JMA");
  const std::size_t n = jma_columns(lines[header]).size();
  const double unit = jma_unit(lines, path, as);
  SampledSignal record{jma_step(lines, path), {}};
  for (std::size_t i = header + 1; i < lines.size(); ++i) {
    if (trim(lines[i]).empty()) continue;
    const std::string where = fmt::format("{}:{}", path, i + 1);
    const auto cells = jma_columns(lines[i]);
    if (cells.size() != n) throw DataError(fmt::format("{}: {} cells, the header has {}", where, cells.size(), n));
    const auto value = to_number(cells[as.column]);
    if (!value || !std::isfinite(*value))
      throw DataError(fmt::format("{}: \"{}\" is not a finite number", where, cells[as.column].substr(0, 40)));
    record.values.push_back(*value * unit);
  }
  if (record.values.size() < 2)
    throw DataError(fmt::format("{}: {} samples, at least 2 are needed", path, record.values.size()));
  take_mean_off(record);
  for (const double value : record.values) require_plausible(value, as.gravity, path);
  return record;
}

} // namespace rimpact

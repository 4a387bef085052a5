#include "io/records/record_knet_csv.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "io/records/header_check.h"
#include "io/records/record.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact {
namespace {

constexpr std::size_t table_preamble = 40; // lines
constexpr std::size_t first_component = 2;

/// "#KEY" and the line below it, without their marks; empty: there is no such line.
std::string below(const std::vector<std::string_view> &lines, std::string_view key) {
  for (std::size_t i = 0; i + 1 < std::min(table_preamble, lines.size()); ++i)
    if (const auto line = trim(lines[i]); line.starts_with('#') && line.substr(1).starts_with(key)) {
      const auto value = trim(lines[i + 1]);
      return std::string(value.starts_with('#') ? value.substr(1) : value);
    }
  return {};
}

/// The line that names the columns; the number of lines: there is none.
std::size_t line_of_columns(const std::vector<std::string_view> &lines) {
  for (std::size_t i = 0; i < std::min(table_preamble, lines.size()); ++i)
    if (trim(lines[i]).starts_with("#Time,RelativeTime(s),")) return i;
  return lines.size();
}

/// "N-S" of "N-S(gal)", for each component; empty where there are none.
std::vector<std::string> components(std::string_view text) {
  const auto lines = lines_of(text);
  const std::size_t header = line_of_columns(lines);
  std::vector<std::string> names;
  if (header == lines.size()) return names;
  const auto cells = split(trim(lines[header]), ',');
  for (std::size_t i = first_component; i < cells.size(); ++i)
    names.emplace_back(trim(cells[i].substr(0, cells[i].find('('))));
  return names;
}

double number_in(std::string_view cell, const std::string &where) {
  const auto value = to_number(trim(cell));
  if (!value || !std::isfinite(*value))
    throw DataError(fmt::format("{}: \"{}\" is not a finite number", where, cell.substr(0, 40)));
  return *value;
}

} // namespace

bool is_knet_table(std::string_view text) {
  return trim(text.substr(0, text.find('\n'))) == "#K-NET CSV";
}

std::vector<Channel> channels_of_knet_csv(std::string_view text) {
  std::vector<Channel> channels{{text, 0}};
  for (std::size_t i = 1; i < components(text.substr(0, 4000)).size(); ++i) channels.push_back({text, i});
  return channels;
}

RecordHead head_of_knet_csv(const Channel &channel) {
  const auto text = channel.text.substr(0, 4000);
  const auto names = components(text);
  if (channel.column >= names.size()) return {};
  const std::string code = below(lines_of(text), "Code,");
  RecordHead head{code.substr(0, code.find(',')), names[channel.column]};
  if (names.size() == 6) {
    const char *const axes[] = {"N-S", "E-W", "U-D"};
    head.direction = axes[channel.column % 3], head.instrument = channel.column < 3 ? "borehole" : "surface";
  }
  return head;
}

SampledSignal parse_knet_csv(const std::string &text, const std::string &path, const ReadAs &as) {
  const auto lines = lines_of(text);
  const std::size_t header = line_of_columns(lines), n = components(text).size();
  if (header == lines.size() || as.column >= n)
    throw DataError(path + ": no line #Time,RelativeTime(s),... names the columns: not a table of K-NET");
  const auto hertz = to_number(below(lines, "SamplingFrequency(Hz)"));
  if (!hertz || !(*hertz >= 1 && *hertz <= 10'000))
    throw DataError(fmt::format("{}: SamplingFrequency(Hz) \"{}\" is not between 1 and 10000", path,
                                below(lines, "SamplingFrequency(Hz)").substr(0, 40)));
  SampledSignal record{1 / *hertz, {}};
  for (std::size_t i = header + 1; i < lines.size(); ++i) {
    if (trim(lines[i]).empty()) continue;
    const std::string where = fmt::format("{}:{}", path, i + 1);
    const auto cells = split(trim(lines[i]), ',');
    if (cells.size() != n + first_component)
      throw DataError(fmt::format("{}: {} cells, the header has {}", where, cells.size(), n + first_component));
    const double time = number_in(cells[1], where), due = record.dt * static_cast<double>(record.values.size());
    if (std::abs(time - due) > 0.5 * record.dt)
      throw DataError(fmt::format("{}: RelativeTime(s) is {:g}, at {:g} Hz sample {} is at {:g} s", where, time, *hertz,
                                  record.values.size() + 1, due));
    record.values.push_back(number_in(cells[first_component + as.column], where) * as.unit.value_or(0.01));
  }
  if (record.values.size() < 2)
    throw DataError(fmt::format("{}: truncated: {} samples, at least 2 are needed", path, record.values.size()));
  if (const auto length = to_number(below(lines, "DurationTime(s)"));
      length && std::abs(static_cast<double>(record.values.size()) - *length * *hertz) > *hertz)
    require_count(path, "DurationTime(s) times SamplingFrequency(Hz)", *length * *hertz, record.values.size());
  take_mean_off(record);
  for (const double value : record.values) require_plausible(value, as.gravity, path);
  return record;
}

} // namespace rimpact

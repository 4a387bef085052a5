#include "io/records/record_csmip_raw.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "io/records/header_check.h"
#include "io/records/record.h"
#include "io/records/record_format.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact {
namespace {

/// Lines of text, of integers (16 in columns of 5) and of reals (8 in columns of 10).
constexpr std::size_t raw_text_lines = 13, raw_integer_lines = 7, raw_integers_a_line = 16, raw_real_lines = 7,
                      raw_reals_a_line = 8;
constexpr std::size_t raw_integer_column = 5, raw_real_column = 10, raw_pair_column = 7, raw_value_column = 9;
/// Places, from 0, among the integers: samples of even spacing, of pairs; among the reals: length [s].
constexpr std::size_t raw_place_of_even_count = 32, raw_place_of_count = 27, raw_place_of_length = 2;

bool line_has_letters(std::string_view line) {
  return std::any_of(line.begin(), line.end(), [](char c) { return (c | 32) >= 'a' && (c | 32) <= 'z'; });
}

/// Of "UNITS OF UNCOR ACCEL ARE SEC AND G/10": the last word there that is a unit of acceleration.
double raw_unit(const std::vector<std::string_view> &lines, const std::string &path, const ReadAs &as) {
  if (as.unit) return *as.unit;
  for (std::size_t i = 0; i < std::min(raw_text_lines, lines.size()); ++i) {
    const std::string line = upper(lines[i]);
    if (line.find("UNITS") == std::string::npos) continue;
    for (const auto word : split(std::string_view(line).substr(line.find("UNITS")), ' ')) {
      auto name = trim(word);
      while (!name.empty() && (name.back() == '.' || name.back() == ',')) name.remove_suffix(1);
      if (name == "G/10") return as.gravity / 10;
      if (const auto unit = acceleration_unit(name, as.gravity)) return *unit;
    }
  }
  throw DataError(path + ": no line \"UNITS ...\" names a unit that is known (G/10, G, cm/sec/sec)");
}

/// The interval of instants that are even to a tenth of it: they are rounded to thousandths.
double even_step(const std::vector<double> &times, const std::string &path) {
  const double dt = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  for (std::size_t i = 0; i < times.size(); ++i)
    if (!(std::abs(times[i] - times.front() - dt * static_cast<double>(i)) <= 0.1 * dt + 6e-4))
      throw DataError(
          fmt::format("{}: holds an uncorrected accelerogram (V1) whose samples are not evenly spaced ({} s "
                      "is sample {}); take the corrected one (V2)",
                      path, times[i], i + 1));
  return dt;
}

SampledSignal record_of_pairs(const std::vector<std::string_view> &lines, std::size_t first, std::size_t npts,
                              const std::string &path) {
  const auto pairs = read_values(lines, first, 2 * npts, raw_pair_column, path);
  std::vector<double> times;
  SampledSignal record{0, {}};
  for (std::size_t i = 0; i < npts; ++i) times.push_back(pairs[2 * i]), record.values.push_back(pairs[2 * i + 1]);
  record.dt = even_step(times, path);
  return record;
}

} // namespace

bool opens_csmip_raw(std::string_view line) {
  return upper(trim(line.substr(0, 100))).starts_with("UNCORRECTED ACCELEROGRAM");
}

SampledSignal parse_csmip_raw(const std::string &text, const std::string &path, const ReadAs &as) {
  const auto lines = lines_of(text);
  const auto integers =
      read_values(lines, raw_text_lines, raw_integer_lines * raw_integers_a_line, raw_integer_column, path);
  const auto reals =
      read_values(lines, raw_text_lines + raw_integer_lines, raw_real_lines * raw_reals_a_line, raw_real_column, path);
  const double even = integers[raw_place_of_even_count], count = even > 0 ? even : integers[raw_place_of_count];
  const double length = reals[raw_place_of_length];
  if (!(count >= 2 && count <= 1e9))
    throw DataError(fmt::format("{}: the number of samples {} must be a whole number >= 2", path, count));
  const auto npts = static_cast<std::size_t>(count);
  const std::size_t first = raw_text_lines + raw_integer_lines + raw_real_lines;
  SampledSignal record =
      first < lines.size() && line_has_letters(lines[first])
          ? SampledSignal{length / (count - 1), read_values(lines, first + 1, npts, raw_value_column, path)}
          : record_of_pairs(lines, first, npts, path);
  if (!(record.dt > 0 && record.dt <= longest_step))
    throw DataError(fmt::format("{}: the sampling interval {} s must be > 0 and <= {}", path, record.dt, longest_step));
  const double spanned = record.dt * (count - 1);
  constexpr double slack = 0.02;
  if (length > 0 && std::abs(spanned - length) > slack * length + record.dt)
    throw DataError(fmt::format("{}: the third real says a length of {} s, its samples span {:.4g} s: header and data "
                                "disagree",
                                path, length, spanned));
  const double unit = raw_unit(lines, path, as);
  for (auto &value : record.values) {
    value *= unit;
    require_plausible(value, as.gravity, path);
  }
  return record;
}

} // namespace rimpact

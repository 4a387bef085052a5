// GeoNet (GNS Science) V1A and V2A: three components, each of 16 lines of text, ten of numbers, then accelerations.
#include "io/files/error.h"
#include "io/files/text.h"
#include "io/records/header_check.h"
#include "io/records/record.h"
#include "io/records/record_format.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact {
namespace {

constexpr std::size_t text_lines = 16, number_lines = 10, numbers_a_line = 10, column = 8;
/// Places among the hundred numbers of the header.
constexpr std::size_t place_of_count = 33, place_of_velocities = 34, place_of_step = 65;
constexpr double millimetre = 1e-3; // accelerations are in mm/s^2

/// Of "Acceleration:  Peak  -2080.5 mm/s/s at  23.28 s".
std::optional<double> stated_peak(const std::vector<std::string_view> &lines) {
  const std::string said = upper(header_value(lines, text_lines, "ACCELERATION:"));
  if (!said.starts_with("PEAK")) return std::nullopt;
  const auto rest = trim(std::string_view(said).substr(4));
  return to_number(rest.substr(0, rest.find(' ')));
}

} // namespace

bool opens_geonet(std::string_view line) {
  const std::string head = upper(line.substr(0, 100));
  return head.find("CORRECTED ACCELEROGRAM") != std::string::npos && head.find("GNS SCIENCE") != std::string::npos;
}

std::vector<Channel> channels_of_geonet(std::string_view text) {
  return parts_at(text, opens_geonet);
}

RecordHead head_of_geonet(const Channel &channel) {
  const auto lines = lines_of(channel.text.substr(0, 4000));
  const std::string site = header_value(lines, text_lines, "SITE ");
  constexpr std::size_t line_of_time = 7;
  return {site.substr(0, site.find(' ')) + " " +
              std::string(lines.size() > line_of_time ? trim(lines[line_of_time]) : ""),
          header_value(lines, text_lines, "COMPONENT ")};
}

SampledSignal parse_geonet(const std::string &text, const std::string &path, const ReadAs &as) {
  const auto lines = lines_of(text);
  const auto header = read_values(lines, text_lines, number_lines * numbers_a_line, column, path);
  const double npts = header[place_of_count], dt = header[place_of_step];
  if (!(npts >= 2 && npts <= 1e9 && npts == std::floor(npts)))
    throw DataError(fmt::format("{}: the number of samples {} (line {}) must be a whole number >= 2", path, npts, 20));
  if (!(dt > 0 && dt <= longest_step))
    throw DataError(
        fmt::format("{}: the sampling interval {} s (line {}) must be > 0 and <= {}", path, dt, 23, longest_step));
  std::size_t next = 0;
  SampledSignal record{
      dt, read_values(lines, text_lines + number_lines, static_cast<std::size_t>(npts), column, path, &next)};
  if (header[place_of_velocities] == 0) refuse_numbers(lines, next, record.values.size(), path);
  for (auto &value : record.values) {
    value *= as.unit.value_or(millimetre);
    require_plausible(value, as.gravity, path);
  }
  if (const auto peak = stated_peak(lines)) require_peak(path, "Acceleration: Peak", *peak * millimetre, record);
  return record;
}

} // namespace rimpact

// ESM and ITACA ASCII: lines KEY: VALUE, then one acceleration a line.
#include "files/error.h"
#include "files/text.h"
#include "records/record.h"
#include "records/record_format.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact {
namespace {

constexpr std::size_t header_lines = 64;

double unit_named(const std::string &name, const std::string &path, double gravity) {
  const std::string unit = upper(name);
  for (const char *cm : {"CM/S^2", "CM/S2", "CM/S**2", "CM/S/S", "GAL"})
    if (unit == cm) return 0.01;
  for (const char *m : {"M/S^2", "M/S2", "M/S**2", "M/S/S"})
    if (unit == m) return 1;
  if (unit == "G") return gravity;
  throw DataError(
      fmt::format("{}: UNITS \"{}\" of the acceleration are not known (cm/s^2, m/s^2, g)", path, name.substr(0, 40)));
}

double number_of(const std::vector<std::string_view> &lines, const char *key, const std::string &path) {
  const std::string text = header_value(lines, header_lines, key);
  const auto value = to_number(text);
  if (!value || !std::isfinite(*value))
    throw DataError(fmt::format("{}: {} \"{}\" is not a number", path, key, text.substr(0, 40)));
  return *value;
}

bool is_header(std::string_view line) {
  const auto colon = line.find(':');
  return colon != std::string_view::npos && line.substr(0, colon).find_first_of("0123456789.- ") != 0;
}

} // namespace

RecordHead head_of_esm(std::string_view text) {
  const auto lines = lines_of(text);
  const auto said = [&](const char *key) { return header_value(lines, header_lines, key); };
  const std::string code = said("STATION_CODE");
  return {code.empty() ? code
                       : fmt::format("{} {}{}{} {}", said("EVENT_ID"), said("NETWORK"),
                                     said("NETWORK").empty() ? "" : ".", code, said("LOCATION")),
          said("STREAM")};
}

SampledSignal parse_esm(const std::string &text, const std::string &path, double gravity) {
  const auto lines = lines_of(text);
  const std::string kind = upper(header_value(lines, header_lines, "DATA_TYPE"));
  if (!kind.empty() && kind.find("ACCELERATION") == std::string::npos)
    throw DataError(fmt::format("{}: the file holds {}, an acceleration record is needed", path, kind.substr(0, 40)));
  const double dt = number_of(lines, "SAMPLING_INTERVAL_S", path), npts = number_of(lines, "NDATA", path);
  if (!(dt > 0 && dt <= longest_step))
    throw DataError(fmt::format("{}: SAMPLING_INTERVAL_S {} must be > 0 and <= {}", path, dt, longest_step));
  if (!(npts >= 2 && npts <= 1e9 && npts == std::floor(npts)))
    throw DataError(fmt::format("{}: NDATA {} must be a whole number >= 2", path, npts));
  const double unit = unit_named(header_value(lines, header_lines, "UNITS"), path, gravity);
  std::size_t first = 0;
  while (first < std::min(header_lines, lines.size()) && (is_header(lines[first]) || trim(lines[first]).empty()))
    ++first;
  SampledSignal record{dt, read_values(lines, first, static_cast<std::size_t>(npts), 0, path)};
  for (auto &value : record.values) {
    value *= unit;
    require_plausible(value, gravity, path);
  }
  return record;
}

} // namespace rimpact

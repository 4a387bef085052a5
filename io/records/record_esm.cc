// ESM and ITACA ASCII: lines KEY: VALUE, then one acceleration a line.
#include "io/files/error.h"
#include "io/files/text.h"
#include "io/records/header_check.h"
#include "io/records/record.h"
#include "io/records/record_format.h"
#include "io/records/record_units.h"
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace rimpact {
namespace {

constexpr std::size_t header_lines = 64;

/// A number that the header may lack.
std::optional<double> number_if(const std::vector<std::string_view> &lines, const char *key) {
  return to_number(header_value(lines, header_lines, key));
}

double number_of(const std::vector<std::string_view> &lines, const char *key, const std::string &path) {
  const std::string text = header_value(lines, header_lines, key);
  const auto value = to_number(text);
  if (!value || !std::isfinite(*value))
    throw DataError(fmt::format("{}: {} \"{}\" is not a number", path, key, text.substr(0, 40)));
  return *value;
}

/// To the file's end. A line of two numbers is not of this form: spectra have them.
std::vector<double> one_value_a_line(const std::vector<std::string_view> &lines, std::size_t first,
                                     const std::string &path) {
  std::vector<double> values;
  for (std::size_t i = first; i < lines.size(); ++i) {
    const auto word = trim(lines[i]);
    if (word.empty()) continue;
    const auto value = to_number(word);
    if (!value || !std::isfinite(*value))
      throw DataError(fmt::format("{}:{}: \"{}\" is not a finite number, one a line ({} values read)", path, i + 1,
                                  word.substr(0, 40), values.size()));
    values.push_back(*value);
  }
  return values;
}

bool is_header(std::string_view line) {
  const auto colon = line.find(':');
  return colon != std::string_view::npos && line.substr(0, colon).find_first_of("0123456789.- ") != 0;
}

} // namespace

RecordHead head_of_esm(const Channel &channel) {
  const auto lines = lines_of(channel.text);
  const auto said = [&](const char *key) { return header_value(lines, header_lines, key); };
  const std::string code = said("STATION_CODE");
  return {code.empty() ? code
                       : fmt::format("{} {}{}{} {}", said("EVENT_ID"), said("NETWORK"),
                                     said("NETWORK").empty() ? "" : ".", code, said("LOCATION")),
          said("STREAM")};
}

SampledSignal parse_esm(const std::string &text, const std::string &path, const ReadAs &as) {
  const auto lines = lines_of(text);
  const std::string kind = upper(header_value(lines, header_lines, "DATA_TYPE"));
  if (!kind.empty() && (kind.find("ACCELERATION") == std::string::npos || kind.find("SPECTR") != std::string::npos))
    throw DataError(fmt::format("{}: the file holds {}, an acceleration record is needed", path, kind.substr(0, 40)));
  const double dt = number_of(lines, "SAMPLING_INTERVAL_S", path), npts = number_of(lines, "NDATA", path);
  if (!(dt > 0 && dt <= longest_step))
    throw DataError(fmt::format("{}: SAMPLING_INTERVAL_S {} must be > 0 and <= {}", path, dt, longest_step));
  if (!(npts >= 2 && npts <= 1e9 && npts == std::floor(npts)))
    throw DataError(fmt::format("{}: NDATA {} must be a whole number >= 2", path, npts));
  const std::string name = header_value(lines, header_lines, "UNITS");
  const auto unit = as.unit ? as.unit : acceleration_unit(name, as.gravity);
  if (!unit)
    throw DataError(
        fmt::format("{}: UNITS \"{}\" of the acceleration are not known (cm/s^2, m/s^2, g)", path, name.substr(0, 40)));
  std::size_t first = 0;
  while (first < std::min(header_lines, lines.size()) && (is_header(lines[first]) || trim(lines[first]).empty()))
    ++first;
  SampledSignal record{dt, one_value_a_line(lines, first, path)};
  require_count(path, "NDATA", npts, record.values.size());
  for (auto &value : record.values) {
    value *= *unit;
    require_plausible(value, as.gravity, path);
  }
  if (const auto peak = number_if(lines, "PGA_CM/S^2")) require_peak(path, "PGA_CM/S^2", *peak / 100, record);
  return record;
}

} // namespace rimpact

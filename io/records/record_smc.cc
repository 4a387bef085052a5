#include "io/records/record_smc.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "io/records/header_check.h"
#include "io/records/record.h"
#include "io/records/record_format.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact {
namespace {

constexpr std::size_t smc_text_lines = 11, smc_integer_lines = 6, smc_integers = 48, smc_integer_column = 10;
constexpr std::size_t smc_real_lines = 10, smc_reals = 50, smc_real_column = 15, smc_value_column = 10;
/// Places, from 0, among the smc_integers and smc_reals.
constexpr std::size_t smc_place_of_dip = 12, smc_place_of_azimuth = 13, smc_place_of_remarks = 15,
                      smc_place_of_count = 16;
constexpr std::size_t smc_place_of_rate = 1;
constexpr double smc_unit = 0.01; // accelerations are in cm/s^2

struct SmcHeader {
  std::vector<double> integers;
  double count = 0, remarks = 0;
};

SmcHeader read_smc_header(const std::vector<std::string_view> &lines, const std::string &path) {
  SmcHeader header{read_values(lines, smc_text_lines, smc_integers, smc_integer_column, path)};
  header.count = header.integers[smc_place_of_count], header.remarks = header.integers[smc_place_of_remarks];
  if (!(header.count >= 2 && header.count <= 1e9))
    throw DataError(
        fmt::format("{}: the number of samples {} (the 17th integer) must be a whole number >= 2", path, header.count));
  if (!(header.remarks >= 0 && header.remarks <= 10'000))
    throw DataError(
        fmt::format("{}: the number of remarks {} (the 16th integer) must be 0 to 10000", path, header.remarks));
  return header;
}

} // namespace

bool opens_smc(std::string_view line) {
  const auto head = upper(trim(line.substr(0, 100)));
  for (const char *known :
       {"1 UNCORRECTED ACCELEROGRAM", "2 CORRECTED ACCELEROGRAM", "3 VELOCITY", "4 DISPLACEMENT", "5 RESPONSE SPECTRA"})
    if (head == known) return true;
  return false;
}

RecordHead head_of_smc(const Channel &channel) {
  try {
    const auto lines = lines_of(channel.text.substr(0, 20'000));
    const auto header = read_smc_header(lines, "");
    const double dip = header.integers[smc_place_of_dip], azimuth = header.integers[smc_place_of_azimuth];
    const std::string station(lines.size() > 3 ? trim(lines[2].substr(0, 4)) : "");
    const std::string time(lines.size() > 3 ? trim(lines[3].substr(0, 40)) : "");
    const bool is_vertical = dip == 0 || dip == 180; // from upwards; a level axis has 90
    const bool is_level = azimuth >= 0 && azimuth <= 360;
    return {station.empty() ? station : station + " " + time, is_vertical ? std::string("UP")
                                                              : is_level  ? fmt::format("{:.0f}", azimuth)
                                                                          : std::string()};
  } catch (const DataError &) {
    return {};
  }
}

SampledSignal parse_smc(const std::string &text, const std::string &path, const ReadAs &as) {
  const auto lines = lines_of(text);
  const std::string kind = lines.empty() ? std::string() : upper(trim(lines[0]));
  if (kind.find("ACCELEROGRAM") == std::string::npos)
    throw DataError(fmt::format("{}: the file holds {}, an acceleration record is needed", path, kind.substr(0, 40)));
  const SmcHeader header = read_smc_header(lines, path);
  const double rate =
      read_values(lines, smc_text_lines + smc_integer_lines, smc_reals, smc_real_column, path)[smc_place_of_rate];
  if (!(rate >= 1 && rate <= 1e5))
    throw DataError(
        fmt::format("{}: the sampling rate {} per second (the second real) must be 1 to 100000", path, rate));
  const std::size_t first =
      smc_text_lines + smc_integer_lines + smc_real_lines + static_cast<std::size_t>(header.remarks);
  const auto npts = static_cast<std::size_t>(header.count);
  std::size_t next = 0;
  SampledSignal record{1 / rate, read_values(lines, first, npts, smc_value_column, path, &next)};
  refuse_numbers(lines, next, npts, path);
  for (auto &value : record.values) {
    value *= as.unit.value_or(smc_unit);
    require_plausible(value, as.gravity, path);
  }
  return record;
}

} // namespace rimpact

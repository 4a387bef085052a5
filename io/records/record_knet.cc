// K-NET and KiK-net ASCII (NIED): 17 lines of header, counts in columns.
#include "io/files/error.h"
#include "io/files/text.h"
#include "io/records/header_check.h"
#include "io/records/record.h"
#include "io/records/record_format.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact {
namespace {

constexpr std::size_t preamble = 17;

/// "3920(gal)/6182761": gal a count.
double scale_of(const std::string &text, const std::string &path) {
  const auto open = text.find('('), close = text.find(")/");
  const auto above = to_number(text.substr(0, open == std::string::npos ? 0 : open));
  const auto below = close == std::string::npos ? std::nullopt : to_number(text.substr(close + 2));
  if (!above || !below || !(*above > 0) || !(*below > 0) || upper(text.substr(open, close - open)) != "(GAL")
    throw DataError(fmt::format("{}: the scale factor \"{}\" is not of the form N(gal)/M", path, text.substr(0, 40)));
  return *above / *below;
}

} // namespace

RecordHead head_of_knet(const Channel &channel) {
  const auto lines = lines_of(channel.text);
  std::string direction = header_value(lines, preamble, "DIR."), place;
  const char *const axes[] = {"N-S", "E-W", "U-D"};
  if (direction.size() == 1 && direction[0] >= '1' && direction[0] <= '6') {
    const int number = direction[0] - '1';
    direction = axes[number % 3], place = number < 3 ? " borehole" : " surface";
  }
  const std::string code = header_value(lines, preamble, "STATION CODE");
  return {code.empty() ? code : code + place + " " + header_value(lines, preamble, "RECORD TIME"), direction};
}

SampledSignal parse_knet(const std::string &text, const std::string &path, const ReadAs &as) {
  const auto lines = lines_of(text);
  std::string rate = upper(header_value(lines, preamble, "SAMPLING FREQ(HZ)"));
  if (rate.ends_with("HZ")) rate.resize(rate.size() - 2);
  const auto hertz = to_number(rate);
  if (!hertz || !(*hertz >= 1 && *hertz <= 10'000))
    throw DataError(fmt::format("{}: Sampling Freq(Hz) \"{}\" is not between 1 and 10000", path, rate.substr(0, 40)));
  const double gal = as.unit.value_or(0.01);
  const double scale = scale_of(header_value(lines, preamble, "SCALE FACTOR"), path) * gal; // m/s^2 a count
  std::size_t first = 0;
  while (first < std::min(preamble + 3, lines.size()) && upper(trim(lines[first])).rfind("MEMO", 0) != 0) ++first;
  if (first >= lines.size() || upper(trim(lines[first])).rfind("MEMO", 0) != 0)
    throw DataError(path + ": no line \"Memo.\" closes the header: not a K-NET record");
  SampledSignal record{1 / *hertz, read_values(lines, first + 1, 0, 0, path)};
  const double n_values = static_cast<double>(record.values.size());
  if (const auto length = to_number(header_value(lines, preamble, "DURATION TIME(S)"));
      length && std::abs(n_values - *length * *hertz) > *hertz) // the header rounds to whole seconds
    require_count(path, "Duration Time(s) times Sampling Freq(Hz)", *length * *hertz, record.values.size());
  // The instrument's offset is not motion: NIED's own advice is to take the mean off.
  take_mean_off(record);
  for (auto &value : record.values) {
    value *= scale;
    require_plausible(value, as.gravity, path);
  }
  constexpr double slack = 0.05; // NIED takes another mean
  if (const auto peak = to_number(header_value(lines, preamble, "MAX. ACC. (GAL)")))
    require_peak(path, "Max. Acc. (gal)", *peak / 100, record, slack);
  return record;
}

} // namespace rimpact

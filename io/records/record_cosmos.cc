// COSMOS V2 and CSMIP V2: blocks of text, integers and reals whose lengths they tell, then the accelerations.
#include "io/files/error.h"
#include "io/files/text.h"
#include "io/records/header_check.h"
#include "io/records/record.h"
#include "io/records/record_csmip_raw.h"
#include "io/records/record_format.h"
#include "io/records/record_units.h"
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <regex>

namespace rimpact {
namespace {

/// "6000 acceleration pts, approx  60 secs, units=cm/sec2 (04), Format=(8F10.5)"
struct Counts {
  std::size_t line = 0, npts = 0, width = 0; ///< width of a column, 0: not told
  double unit = 0, dt = 0;
};

double first_number(std::string_view text) {
  const auto end = text.find_first_not_of("0123456789.");
  return to_number(text.substr(0, end)).value_or(0);
}

/// Behind "units=" (COSMOS) or "sec, in" (CSMIP), else a code of COSMOS.
double unit_in(const std::string &line, const ReadAs &as, const std::string &where) {
  if (as.unit) return *as.unit;
  for (const std::string_view opening : {"UNITS=", "UNITS =", " IN "})
    if (const auto at = line.rfind(opening); at != std::string::npos) {
      auto name = trim(std::string_view(line).substr(at + opening.size()));
      name = trim(name.substr(0, name.find_first_of(",(")));
      while (!name.empty() && name.back() == '.') name.remove_suffix(1);
      if (const auto unit = acceleration_unit(name, as.gravity)) return *unit;
    }
  if (line.find("(04)") != std::string::npos) return 0.01;
  if (line.find("(02)") != std::string::npos) return as.gravity;
  throw DataError(fmt::format("{}: the line of counts names no unit that is known (cm/sec2, m/sec2, g)", where));
}

/// Of (8F10.5) or (5E15.6): 10, 15.
std::size_t width_of(const std::string &line) {
  const auto at = line.find("FORMAT");
  const auto open = at == std::string::npos ? line.rfind('(') : line.find('(', at);
  if (open == std::string::npos) return 0;
  for (std::size_t i = open; i + 1 < line.size(); ++i)
    if ((line[i] == 'F' || line[i] == 'E') && std::isdigit(static_cast<unsigned char>(line[i + 1])) != 0) {
      const double width = first_number(std::string_view(line).substr(i + 1, 2));
      return width >= 4 && width <= 30 ? static_cast<std::size_t>(width) : 0;
    }
  return 0;
}

Counts find_counts(const std::vector<std::string_view> &lines, const std::string &path, const ReadAs &as) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string line = upper(trim(lines[i]));
    if (line.find("ACCEL") == std::string::npos ||
        (line.find("PTS") == std::string::npos && line.find("POINTS") == std::string::npos))
      continue;
    const double npts = first_number(line);
    if (!(npts >= 2 && npts <= 1e9 && npts == std::floor(npts))) continue;
    Counts counts{i, static_cast<std::size_t>(npts), width_of(line), 0, 0};
    counts.unit = unit_in(line, as, fmt::format("{}:{}", path, i + 1));
    return counts;
  }
  throw DataError(path + ": no line of counts (\"N acceleration pts, ... units=...\"): not a COSMOS V2 record");
}

/// The interval between samples [s]: of the real header's values the 62nd, in ms, of this series; where it is unknown
/// the 34th, in s, of the raw record. Unknown values are -999.
/// CSMIP says it in the line of counts: "equally spaced at .020 sec".
double interval(const std::vector<std::string_view> &lines, const Counts &counts, const std::string &path) {
  const std::string_view spaced = "SPACED AT", line_of_counts = lines[counts.line];
  if (const std::string said = upper(line_of_counts); said.find(spaced) != std::string::npos)
    return first_number(trim(std::string_view(said).substr(said.find(spaced) + spaced.size())));
  for (std::size_t i = 0; i < counts.line; ++i) {
    const std::string line = upper(trim(lines[i]));
    if (line.find("REAL") == std::string::npos || line.find("HEADER") == std::string::npos) continue;
    const double n = first_number(line);
    if (!(n >= 62 && n <= 1000)) continue;
    const auto values = read_values(lines, i + 1, 62, width_of(line), path);
    return values[61] > 0 ? values[61] / 1000 : values[33];
  }
  return 0;
}

/// V3 of CSMIP and COSMOS.
void refuse_spectra(std::string_view text, const std::string &path) {
  const std::string head = upper(text.substr(0, text.find('\n')));
  if (head.find("SPECTRA") != std::string::npos)
    throw DataError(path + ": holds spectra (V3), no record; take the corrected accelerogram (V2)");
}

/// Of "PEAK ACCELERATION = -98.07 CM/SEC/SEC AT .04 SEC", in the data's unit; none: the headers have no such line.
std::optional<double> stated_peak(const std::vector<std::string_view> &lines, std::size_t n) {
  static const std::regex peak(R"(PEAK ACCEL[A-Z]*\.?\s*[=:]\s*(-?\d*\.?\d+))");
  for (std::size_t i = 0; i < n; ++i) {
    const std::string line = upper(lines[i].substr(0, 200));
    std::smatch part;
    if (line.find("PEAK ACCEL") != std::string::npos && std::regex_search(line, part, peak))
      return to_number(part.str(1));
  }
  return std::nullopt;
}

/// Of a station's head line, which opens every channel.
bool opens_channel(std::string_view line) {
  const std::string head = upper(trim(line));
  for (const char *opening :
       {"CORRECTED ACCELERATION", "CORRECTED ACCELEROGRAM", "UNCORRECTED ACCELERATION", "RAW ACCELERATION"})
    if (head.starts_with(opening)) return true;
  return false;
}

} // namespace

RecordHead head_of_cosmos(const Channel &channel_given) {
  static const std::regex channel(R"(\bCHA?N(?:NEL)?\.?\s*\d+\s*[:,]?\s*(?:COMP(?:ONENT)?\.?\s*:?)?\s*([A-Z0-9]+))"),
      number(R"(STATI?O?N NO\.?\s*:?\s*(\S+))"), recorded(R"(\bRCRD OF\s*(.*))");
  RecordHead head;
  std::size_t n_lines = 0;
  constexpr std::size_t preamble = 30; // of text, before the headers of numbers
  for (const auto line : lines_of(channel_given.text)) {
    const std::string words = upper(line.substr(0, 200)); // a damaged file may have no ends of lines
    std::smatch part;
    if (++n_lines > preamble || words.find("HEADER VALUES") != std::string::npos) break;
    if (head.direction.empty() && std::regex_search(words, part, channel)) head.direction = part[1];
    if (std::regex_search(words, part, number)) head.station = part[1].str() + head.station;
    if (std::regex_search(words, part, recorded)) head.station.append(" ").append(trim(part[1].str().substr(0, 40)));
  }
  return head;
}

std::vector<Channel> channels_of_cosmos(std::string_view text) {
  const auto first = text.substr(0, text.find('\n'));
  if (upper(first).find("SPECTRA") != std::string::npos) return {{text}};
  return parts_at(text, opens_csmip_raw(first) ? opens_csmip_raw : opens_channel); // V1's first line is V2's second
}

SampledSignal parse_cosmos_v2(const std::string &text, const std::string &path, const ReadAs &as) {
  refuse_spectra(text, path);
  if (opens_csmip_raw(text.substr(0, text.find('\n')))) return parse_csmip_raw(text, path, as);
  const auto lines = lines_of(text);
  Counts counts = find_counts(lines, path, as);
  const double dt = interval(lines, counts, path);
  if (!(dt > 0 && dt <= longest_step))
    throw DataError(
        fmt::format("{}: the sampling interval {} s (62nd or 34th value of the real header) must be > 0 and <= {}",
                    path, dt, longest_step));
  std::size_t next = 0;
  SampledSignal record{dt, read_values(lines, counts.line + 1, counts.npts, counts.width, path, &next)};
  refuse_numbers(lines, next, counts.npts, path);
  for (auto &value : record.values) {
    value *= counts.unit;
    require_plausible(value, as.gravity, path);
  }
  if (const auto peak = stated_peak(lines, counts.line))
    require_peak(path, "Peak acceleration", *peak * counts.unit, record);
  return record;
}

} // namespace rimpact

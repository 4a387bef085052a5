#include "io/files/digit.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "io/records/header_check.h"
#include "io/records/record.h"
#include "io/records/record_format.h"
#include "io/records/record_units.h"
#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace rimpact {
namespace {

/// Reads one Fortran number from the front of `text` and drops it: 1.2, .5, -.3780051E-03, 1.2D-03, 1.2-103.
/// Numbers may touch (fixed columns): a sign ends a number unless it opens an exponent.
std::optional<double> take_number(std::string_view &text) {
  std::size_t i = 0, digits = 0;
  if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
  const std::size_t mantissa_start = i > 0 && text[0] == '+' ? 1 : 0;
  for (bool point = false; i < text.size() && (is_digit(text[i]) || (text[i] == '.' && !point)); ++i)
    text[i] == '.' ? void(point = true) : void(++digits);
  if (digits == 0) return std::nullopt;
  std::string number(text.substr(mantissa_start, i - mantissa_start));
  const auto exponent_at = [&](std::size_t start) { // [sign] digits
    std::size_t j = start;
    if (j < text.size() && (text[j] == '+' || text[j] == '-')) ++j;
    const std::size_t first = j;
    while (j < text.size() && is_digit(text[j])) ++j;
    return std::pair(j > first, j);
  };
  if (i < text.size() && std::string_view("EeDd").find(text[i]) != std::string_view::npos) {
    const auto [good, end] = exponent_at(i + 1);
    if (!good) return std::nullopt;
    number.append(1, 'e').append(text.substr(i + 1, end - i - 1));
    i = end;
  } else if (i < text.size() && (text[i] == '+' || text[i] == '-')) {
    // Fortran drops the E of a three-digit exponent.
    const auto [good, end] = exponent_at(i);
    if (good && end == i + 4 && (end == text.size() || text[end] == ' ')) {
      number.append(1, 'e').append(text.substr(i, 4));
      i = end;
    }
  }
  if (const auto plus = number.find("e+"); plus != std::string::npos) number.erase(plus + 1, 1);
  text.remove_prefix(i);
  return to_number(number);
}

std::string_view skip_blanks(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t' || text.front() == ',')) text.remove_prefix(1);
  return text;
}

/// The number behind NAME= (blanks allowed), or nothing.
std::optional<double> number_after(const std::string &line, std::string_view name) {
  for (auto at = line.find(name); at != std::string::npos; at = line.find(name, at + 1)) {
    if (at > 0 && std::isalpha(static_cast<unsigned char>(line[at - 1]))) continue;
    std::string_view rest = trim(std::string_view(line).substr(at + name.size()));
    if (rest.empty() || (rest.front() != '=' && rest.front() != ':')) continue;
    rest = trim(rest.substr(1));
    if (const auto value = take_number(rest)) return value;
  }
  return std::nullopt;
}

struct Header {
  double npts = 0, dt = 0;
  double unit = 0;           ///< [m/s^2]
  double peak = 0;           ///< in that unit, as older files tell it; 0: not told
  std::size_t data_line = 0; ///< index of the first line of values
};

/// What follows UNITS OF, UNITS:, UNITS =, UNITS IN, UNITS ( or UNITS in a header line, or else IN or ( behind TIME
/// SERIES or TIME HISTORY; empty: the line names no unit.
std::string_view unit_name(std::string_view line) {
  const auto behind = [&](std::string_view word, std::size_t from) {
    const auto at = line.find(word, from);
    return at == std::string_view::npos ? std::string_view() : trim(line.substr(at + word.size()));
  };
  if (auto rest = behind("UNITS", 0); !rest.empty()) {
    for (const std::string_view opening : {"OF ", "IN ", "ARE ", ":", "=", "("})
      if (rest.starts_with(opening)) return trim(rest.substr(opening.size()));
    return rest;
  }
  for (const std::string_view series : {"TIME SERIES", "TIME HISTORY"})
    if (const auto at = line.find(series); at != std::string_view::npos)
      for (const std::string_view opening : {" IN ", "("})
        if (const auto name = behind(opening, at);
            name.substr(0, name.find(' ')).find_first_of("/*^") != std::string_view::npos)
          return name; // written as a unit, not a place
  return {};
}

/// Metres per second squared of the units named in a header line, or what the reader was told; velocity and
/// displacement are refused.
std::optional<double> unit_of(const std::string &line, const std::string &where, const ReadAs &as) {
  const auto says = [&](const char *word) { return line.find(word) != std::string::npos; };
  if (!says("TIME SERIES") && !says("TIME HISTORY") && !says("UNITS")) return std::nullopt;
  for (const char *wrong : {"VELOCITY", "DISPLACEMENT"})
    if (says(wrong))
      throw DataError(fmt::format("{}: the file holds {}, an acceleration record (AT2) is needed", where,
                                  wrong[0] == 'V' ? "velocity" : "displacement"));
  const auto name = unit_name(line);
  if (as.unit) return as.unit;
  if (name.empty()) return std::nullopt;
  if (const auto unit = leading_acceleration_unit(name, as.gravity)) return unit;
  throw DataError(
      fmt::format("{}: the unit \"{}\" of the acceleration is not known (G, CM/S/S, M/S/S, without a factor)", where,
                  name.substr(0, 40)));
}

/// NPTS and DT of a line, as "NPTS= 2000, DT= .0200 SEC" or "2000 .0200 NPTS, DT".
bool read_sampling(const std::string &line, Header &header) {
  if (line.find("NPTS") == std::string::npos) return false;
  const auto npts = number_after(line, "NPTS"), dt = number_after(line, "DT");
  if (npts && dt) {
    header.npts = *npts, header.dt = *dt;
    return true;
  }
  std::string_view rest = skip_blanks(line);
  const auto first = take_number(rest);
  rest = skip_blanks(rest);
  const auto second = take_number(rest);
  if (!first || !second) return false;
  header.npts = *first, header.dt = *second;
  return true;
}

Header read_header(const std::vector<std::string_view> &lines, const std::string &path, const ReadAs &as) {
  Header header;
  constexpr std::size_t n_header_lines = 12; // PEER has 4; others put comments above
  for (std::size_t i = 0; i < std::min(lines.size(), n_header_lines); ++i) {
    const std::string line = upper(trim(lines[i]));
    const std::string where = fmt::format("{}:{}", path, i + 1);
    if (const auto unit = unit_of(line, where, as)) header.unit = *unit;
    if (const auto peak = number_after(line, "PGA")) header.peak = *peak;
    if (!read_sampling(line, header)) continue;
    if (header.unit == 0) header.unit = as.unit.value_or(as.gravity); // the form's own unit
    if (!(header.npts >= 2 && header.npts <= 1e9 && header.npts == std::floor(header.npts)))
      throw DataError(fmt::format("{}: NPTS {} must be a whole number >= 2", where, header.npts));
    if (line.find("MSEC") != std::string::npos || line.find("MILLI") != std::string::npos)
      throw DataError(fmt::format("{}: DT is in milliseconds, seconds are needed", where));
    if (!(header.dt > 0 && header.dt <= longest_step))
      throw DataError(fmt::format("{}: DT {} s must be > 0 and <= {}", where, header.dt, longest_step));
    header.data_line = i + 1;
    return header;
  }
  throw DataError(fmt::format("{}: no line with NPTS and DT among the first {}: not an AT2 record", path,
                              std::min(lines.size(), n_header_lines)));
}

/// Padding with zeros after the last value is usual; anything else says that NPTS or the data are wrong.
void refuse_surplus(std::string_view rest, const std::string &where, std::size_t expected) {
  for (rest = skip_blanks(rest); !rest.empty(); rest = skip_blanks(rest)) {
    const auto value = take_number(rest);
    if (!value) return; // a remark
    if (*value != 0)
      throw DataError(fmt::format("{}: {:g} comes after the {} values that NPTS promises: NPTS or the data are wrong",
                                  where, *value, expected));
  }
}

} // namespace

RecordHead head_of_at2(const Channel &channel) {
  const auto lines = lines_of(channel.text.substr(0, 4000));
  if (lines.size() < 4) return {};
  const auto title = lines[1];
  const auto comma = title.rfind(',');
  if (comma == std::string_view::npos) return {};
  auto direction = trim(title.substr(comma + 1));
  direction = trim(direction.substr(0, direction.find('('))); // "270 (CDMG STATION 89324)"
  return {std::string(trim(title.substr(0, comma))), std::string(direction)};
}

std::vector<Channel> channels_of_at2(std::string_view text) {
  const auto lines = lines_of(text);
  constexpr std::size_t n_header_lines = 4;
  std::vector<std::size_t> starts; // of lines, three above the one with NPTS
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].find_first_of("Nn") == std::string_view::npos || upper(lines[i]).find("NPTS") == std::string::npos)
      continue;
    const std::size_t start = i + 1 >= n_header_lines ? i + 1 - n_header_lines : 0;
    if (starts.empty() || start > starts.back() + n_header_lines) starts.push_back(start);
  }
  if (starts.size() < 2) return {{text}};
  std::vector<Channel> channels;
  for (std::size_t k = 0; k < starts.size(); ++k) {
    const auto from = k == 0 ? 0 : static_cast<std::size_t>(lines[starts[k]].data() - text.data());
    const auto to =
        k + 1 < starts.size() ? static_cast<std::size_t>(lines[starts[k + 1]].data() - text.data()) : text.size();
    channels.push_back({text.substr(from, to - from)});
  }
  return channels;
}

SampledSignal parse_at2(const std::string &text, const std::string &path, const ReadAs &as) {
  const auto lines = lines_of(text);
  const Header header = read_header(lines, path, as);
  const auto expected = static_cast<std::size_t>(header.npts);
  SampledSignal record{header.dt, {}};
  for (std::size_t i = header.data_line; i < lines.size(); ++i) {
    std::string_view rest = skip_blanks(lines[i]);
    while (!rest.empty() && record.values.size() < expected) {
      const std::string_view shown = rest.substr(0, rest.find_first_of(" \t,")).substr(0, 40);
      const auto value = take_number(rest);
      if (!value || !std::isfinite(*value))
        throw DataError(fmt::format("{}:{}: \"{}\" is not a finite number ({} of {} values read)", path, i + 1, shown,
                                    record.values.size(), expected));
      record.values.push_back(*value * header.unit);
      require_plausible(record.values.back(), as.gravity, fmt::format("{}:{}", path, i + 1));
      rest = skip_blanks(rest);
    }
    if (!rest.empty()) refuse_surplus(rest, fmt::format("{}:{}", path, i + 1), expected);
  }
  if (record.values.size() < expected)
    throw DataError(
        fmt::format("{}: truncated: {} values found, NPTS promises {}", path, record.values.size(), expected));
  require_peak(path, "PGA", header.peak * header.unit, record);
  return record;
}

} // namespace rimpact

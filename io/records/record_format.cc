#include "io/records/record_format.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "io/records/record.h"
#include "io/records/record_jma.h"
#include "io/records/record_knet_csv.h"
#include "io/records/record_smc.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact {
namespace {

std::string head_of(std::string_view text) {
  return upper(text.substr(0, 400));
}
bool is_jma(std::string_view text, const std::string &) {
  return is_jma_table(text);
}
bool is_knet_csv(std::string_view text, const std::string &) {
  return is_knet_table(text);
}
bool is_smc(std::string_view text, const std::string &) {
  return opens_smc(text.substr(0, text.find('\n')));
}
bool is_csv(std::string_view, const std::string &ending) {
  return ending == ".CSV";
}
bool is_knet(std::string_view text, const std::string &) {
  const std::string head = head_of(text);
  return head.find("ORIGIN TIME") < 4 && head.find("LAT.") != std::string::npos;
}
bool is_esm(std::string_view text, const std::string &) {
  const std::string head = head_of(text);
  return head.find("EVENT_NAME:") < 4 || head.find("EVENT_ID:") < 4;
}
bool is_cosmos(std::string_view text, const std::string &ending) {
  const auto line = head_of(text.substr(0, text.find('\n')));
  return ending == ".V2" || ending == ".V2C" || line.find("CORRECTED ACCELEROGRAM") != std::string::npos ||
         line.find("CORRECTED ACCELERATION") != std::string::npos ||
         line.find("RAW ACCELERATION") != std::string::npos ||
         (line.find("RESPONSE") != std::string::npos && line.find("SPECTRA") != std::string::npos);
}
bool is_geonet(std::string_view text, const std::string &) {
  return opens_geonet(text.substr(0, text.find('\n')));
}
bool is_at2(std::string_view, const std::string &) {
  return true;
}

} // namespace

const std::vector<RecordFormat> &record_formats() {
  static const std::vector<RecordFormat> formats{
      {"JMA", is_jma, parse_jma, head_of_jma, channels_of_jma},
      {"K-NET CSV", is_knet_csv, parse_knet_csv, head_of_knet_csv, channels_of_knet_csv},
      {"CSV", is_csv, parse_record_csv, head_of_csv, channels_of_csv},
      {"K-NET", is_knet, parse_knet, head_of_knet},
      {"ESM", is_esm, parse_esm, head_of_esm},
      {"GeoNet", is_geonet, parse_geonet, head_of_geonet, channels_of_geonet},
      {"SMC", is_smc, parse_smc, head_of_smc},
      {"COSMOS V2", is_cosmos, parse_cosmos_v2, head_of_cosmos, channels_of_cosmos},
      {"AT2", is_at2, parse_at2, head_of_at2, channels_of_at2}};
  return formats;
}

bool is_record_file(std::string_view beginning, const std::string &ending) {
  if (ending == ".AT2") return true;
  const auto &format = *std::find_if(record_formats().begin(), record_formats().end(),
                                     [&](const auto &each) { return each.is(beginning, ending); });
  if (format.is == is_at2) return false;
  return format.is != is_csv || has_record_header(std::string(beginning), standard_gravity);
}

std::string header_value(const std::vector<std::string_view> &lines, std::size_t n, std::string_view key) {
  for (std::size_t i = 0; i < std::min(n, lines.size()); ++i)
    if (const auto line = trim(lines[i]); upper(line.substr(0, key.size())) == key) {
      auto rest = trim(line.substr(key.size()));
      if (!rest.empty() && rest.front() == ':') rest = trim(rest.substr(1));
      return std::string(rest);
    }
  return {};
}

std::vector<double> read_values(const std::vector<std::string_view> &lines, std::size_t first, std::size_t expected,
                                std::size_t width, const std::string &path, std::size_t *next_line) {
  std::vector<double> values;
  std::size_t i = first;
  for (; i < lines.size() && (expected == 0 || values.size() < expected); ++i) {
    std::string_view rest = lines[i];
    while (!trim(rest).empty() && (expected == 0 || values.size() < expected)) {
      std::string_view word;
      if (width > 0) {
        word = trim(rest.substr(0, width));
        rest.remove_prefix(std::min(width, rest.size()));
        if (word.empty()) continue;
      } else {
        rest = trim(rest);
        const auto end = std::min(rest.find_first_of(" \t"), rest.size());
        word = rest.substr(0, end), rest.remove_prefix(end);
      }
      const auto value = to_number(word);
      if (!value || !std::isfinite(*value))
        throw DataError(fmt::format("{}:{}: \"{}\" is not a finite number ({} values read)", path, i + 1,
                                    word.substr(0, 40), values.size()));
      values.push_back(*value);
    }
  }
  if (values.size() < std::max<std::size_t>(expected, 2))
    throw DataError(fmt::format("{}: truncated: {} values found, {} needed", path, values.size(),
                                std::max<std::size_t>(expected, 2)));
  if (next_line) *next_line = i;
  return values;
}

void refuse_numbers(const std::vector<std::string_view> &lines, std::size_t line, std::size_t npts,
                    const std::string &path) {
  if (line >= lines.size() || trim(lines[line]).empty() ||
      trim(lines[line]).find_first_not_of("0123456789.-+Ee \t") != std::string_view::npos)
    return;
  throw DataError(fmt::format("{}:{}: more numbers come after the {} values that the line of counts promises", path,
                              line + 1, npts));
}

std::vector<Channel> parts_at(std::string_view text, bool (*opens)(std::string_view line)) {
  std::vector<std::size_t> starts;
  for (const auto line : lines_of(text))
    if (opens(line)) starts.push_back(static_cast<std::size_t>(line.data() - text.data()));
  if (starts.size() < 2) return {{text}};
  std::vector<Channel> parts;
  for (std::size_t i = 0; i < starts.size(); ++i)
    parts.push_back({text.substr(starts[i], (i + 1 < starts.size() ? starts[i + 1] : text.size()) - starts[i])});
  return parts;
}

} // namespace rimpact

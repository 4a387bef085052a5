#include "io/files/text.h"
#include <algorithm>
#include <cctype>
#include <charconv>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <numeric>

namespace rimpact {

std::string_view trim(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string upper(std::string_view text) {
  std::string result(text);
  for (char &c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const auto end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::vector<std::string_view> lines_of(std::string_view text) {
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const auto end = text.find_first_of("\r\n");
    lines.push_back(text.substr(0, end));
    if (end == std::string_view::npos) break;
    text.remove_prefix(text.substr(end, 2) == "\r\n" ? end + 2 : end + 1);
  }
  return lines;
}

std::optional<double> to_number(std::string_view text) {
  text = trim(text);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) {
    // from_chars leaves the value alone: an underflow is zero, an overflow is infinite.
    value = text.find('-', 1) != std::string_view::npos ? 0.0 : std::numeric_limits<double>::infinity();
  } else if (error != std::errc()) {
    return std::nullopt;
  }
  if (end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<std::string> decimal_point_for(std::string_view text) {
  std::string number(trim(text));
  const auto comma = number.find(',');
  if (comma == 0 || comma + 1 >= number.size() || comma == std::string::npos) return std::nullopt;
  number[comma] = '.';
  const auto digits = number.find_first_not_of("0123456789+-.eE");
  return digits == std::string::npos && to_number(number) ? std::optional(number) : std::nullopt;
}

std::string hint_at_comma(std::string_view text) {
  const auto with_point = decimal_point_for(text);
  if (!with_point) return {};
  const auto mark = with_point->find('.');
  const bool thousands =
      mark <= 3 && with_point->size() == mark + 4 && with_point->find_first_not_of("0123456789.") == std::string::npos;
  if (!thousands) return "; decimals follow a point: " + *with_point;
  return fmt::format("; {0} with its decimals behind a point, or {1} without a mark of thousands?", *with_point,
                     with_point->substr(0, mark) + with_point->substr(mark + 1));
}

std::vector<std::string> words_near(std::string_view name, const std::vector<std::string> &known) {
  std::vector<std::string> found;
  if (name.size() < 2) return found;
  const std::string word = upper(name);
  for (const auto &each : known)
    if (upper(each).find(word) != std::string::npos) found.push_back(each);
  return found;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row[b.size()];
}

std::optional<std::string> nearest(std::string_view name, const std::vector<std::string> &known) {
  if (name.empty() || name.size() > 64) return std::nullopt;
  std::optional<std::string> best;
  std::size_t best_distance = std::max<std::size_t>(2, name.size() / 3) + 1;
  for (const auto &candidate : known) {
    // "amplitude" is how one forgets the unit of "amplitude_g": a prefix counts as one slip.
    const bool prefix = name.size() >= 3 && candidate.compare(0, name.size(), name) == 0;
    const std::size_t distance = prefix ? 1 : edit_distance(name, candidate);
    if (distance < best_distance) best = candidate, best_distance = distance;
  }
  return best;
}

std::string unknown_word(std::string_view name, const std::vector<std::string> &known) {
  const auto close = nearest(name, known);
  const std::string hint = close ? fmt::format("; did you mean \"{}\"?", *close) : "";
  const std::string shown(name.substr(0, 80));
  return fmt::format("\"{}\" is not known{} (known: {})", shown, hint, fmt::join(known, ", "));
}

} // namespace rimpact

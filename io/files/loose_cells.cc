#include "io/files/loose_cells.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact {
namespace {

void append_utf8(std::string &text, char32_t c) {
  const auto tail = [&](int shift) { text += static_cast<char>(0x80 | ((c >> shift) & 0x3f)); };
  if (c < 0x80) {
    text += static_cast<char>(c);
  } else if (c < 0x800) {
    text += static_cast<char>(0xc0 | (c >> 6)), tail(0);
  } else if (c < 0x10000) {
    text += static_cast<char>(0xe0 | (c >> 12)), tail(6), tail(0);
  } else {
    text += static_cast<char>(0xf0 | (c >> 18)), tail(12), tail(6), tail(0);
  }
}

} // namespace

std::string utf8_text(const std::string &bytes, const std::string &path) {
  const bool little = bytes.starts_with("\xFF\xFE"), big = bytes.starts_with("\xFE\xFF");
  if (!little && !big) return bytes;
  if (bytes.size() % 2 != 0) throw DataError(fmt::format("{}: is UTF-16 and ends within a character", path));
  const auto unit = [&](std::size_t i) {
    const auto first = static_cast<unsigned char>(bytes[i]), second = static_cast<unsigned char>(bytes[i + 1]);
    return static_cast<char32_t>(little ? first | second << 8 : first << 8 | second);
  };
  std::string text;
  for (std::size_t i = 2; i < bytes.size(); i += 2) {
    char32_t c = unit(i);
    if (c >= 0xd800 && c < 0xe000) { // two units make one character
      const char32_t low = i + 3 < bytes.size() ? unit(i + 2) : 0;
      if (c >= 0xdc00 || low < 0xdc00 || low >= 0xe000)
        throw DataError(fmt::format("{}: is UTF-16 with a broken character at byte {}", path, i));
      c = 0x10000 + ((c - 0xd800) << 10) + (low - 0xdc00);
      i += 2;
    }
    append_utf8(text, c);
  }
  return text;
}

std::optional<char> stated_separator(std::string_view line) {
  line = trim(line);
  if (line.size() >= 2 && line.front() == '"' && line.back() == '"') line = line.substr(1, line.size() - 2);
  if (line.size() != 5 || upper(line.substr(0, 4)) != "SEP=") return std::nullopt;
  return line.back();
}

char separator_of(std::string_view header) {
  bool semicolon = false, tab = false, quoted = false;
  for (const char c : header) {
    if (c == '"') quoted = !quoted;
    semicolon = semicolon || (c == ';' && !quoted);
    tab = tab || (c == '\t' && !quoted);
  }
  return semicolon ? ';' : tab ? '\t' : ',';
}

std::vector<std::string> cells_of(std::string_view line, char separator) {
  std::vector<std::string> cells(1);
  bool quoted = false, was_quoted = false;
  const auto close = [&] {
    if (!was_quoted) cells.back() = std::string(trim(cells.back()));
    was_quoted = false;
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      cells.back() += '"', ++i;
    } else if (c == '"' && (quoted || trim(cells.back()).empty())) {
      if (!quoted) cells.back().clear();
      quoted = !quoted, was_quoted = true;
    } else if (c == separator && !quoted) {
      close();
      cells.emplace_back();
    } else if (quoted || !was_quoted ||
               (c != ' ' && c != '\t')) { // blanks behind a closing quote are no part of the cell
      cells.back() += c;
    }
  }
  close();
  return cells;
}

std::optional<double> DecimalReader::number(const std::string &cell, const std::string &place) {
  const auto with_point = decimal_point_for(cell);
  const bool comma = with_point.has_value(), point = !comma && cell.find('.') != std::string::npos;
  const auto value = to_number(comma ? std::string_view(*with_point) : std::string_view(cell));
  if (!value || !std::isfinite(*value)) return std::nullopt;
  if ((comma && point_) || (point && comma_))
    throw DataError(fmt::format(
        "{}: \"{}\" has a decimal {}, but cells before have a decimal {}: one of them stands for thousands; write "
        "the numbers without it",
        place, cell, comma ? "comma" : "point", comma ? "point" : "comma"));
  comma_ = comma_ || comma, point_ = point_ || point;
  return value;
}

} // namespace rimpact

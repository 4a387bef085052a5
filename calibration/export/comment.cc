#include "calibration/export/comment.h"

namespace rimpact::calibration {

namespace {

constexpr std::size_t width = 118;

char plain(unsigned char c) {
  switch (c) {
  case '"':
  case '`':
    return '\'';
  case '\\':
    return '/';
  case '[':
  case '{':
    return '(';
  case ']':
  case '}':
    return ')';
  case '$':
    return 'S';
  case ';':
    return ',';
  default:
    return c < 0x20 || c == 0x7f ? ' ' : c < 0x80 ? static_cast<char>(c) : '?';
  }
}

} // namespace

std::string plain_text(std::string_view text) {
  std::string out;
  for (const unsigned char c : text)
    if ((c & 0xc0) != 0x80) out += plain(c); // the rest of a UTF-8 character adds nothing to its one `?`
  for (std::size_t at; (at = out.find("'''")) != std::string::npos;) out.erase(at, 2);
  return out;
}

std::string comment_line(std::string_view mark, std::string_view text) {
  std::string rest = plain_text(text), out;
  do {
    std::size_t cut = rest.size();
    if (rest.size() > width) {
      cut = rest.rfind(' ', width);
      if (cut == std::string::npos || cut == 0) cut = width;
    }
    out.append(mark).append(" ").append(rest, 0, cut).append("\n");
    rest.erase(0, cut);
    rest.erase(0, rest.find_first_not_of(' '));
  } while (!rest.empty());
  return out;
}

std::string comment_lines(std::string_view mark, const std::vector<std::string> &texts) {
  std::string out;
  for (const auto &text : texts) out += comment_line(mark, text);
  return out;
}

} // namespace rimpact::calibration

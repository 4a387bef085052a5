#include "io/files/toml_comments.h"

#include "io/files/text.h"

namespace rimpact {
namespace {

/// The delimiter of a string that opens at `at`: ", ', """, ''' or none.
std::string_view delimiter_at(std::string_view text, std::size_t at) {
  const char c = text[at];
  if (c != '"' && c != '\'') return {};
  const std::string_view three = text.substr(at, 3);
  return three == "\"\"\"" || three == "'''" ? three : text.substr(at, 1);
}

} // namespace

TomlComments toml_comments(std::string_view text) {
  TomlComments found;
  std::size_t line = 1;
  bool line_begins = true;
  std::string_view inside; // the delimiter of the string we are in
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') {
      ++line, line_begins = true;
      if (inside.size() == 1) inside = {}; // a string of one line that was not closed
    } else if (!inside.empty()) {
      if (c == '\\' && inside[0] == '"' && text.substr(i + 1, 1) != "\n")
        ++i;
      else if (text.substr(i, inside.size()) == inside)
        i += inside.size() - 1, inside = {};
    } else if (c == '#') {
      const auto end = std::min(text.find('\n', i), text.size());
      found.by_line[line] = trim(text.substr(i + 1, end - i - 1));
      i = end - 1;
    } else if (inside = delimiter_at(text, i); !inside.empty()) {
      i += inside.size() - 1, line_begins = false;
    } else if (c != ' ' && c != '\t' && c != '\r') {
      if (line_begins && c == '[') found.headers.insert(line);
      line_begins = false;
    }
  }
  return found;
}

} // namespace rimpact

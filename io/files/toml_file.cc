#include "io/files/toml_file.h"

#include "io/files/error.h"
#include "io/files/text.h"
#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace rimpact {
namespace {

constexpr std::size_t max_bytes = 1 << 20;
constexpr int max_dots_a_key = 64;

/// Where a string that opens at `i` ends: behind its closing quotes, or at the line's end where they are missing (only
/// triple quotes span lines).
std::size_t behind_string(const std::string &text, std::size_t i) {
  const char quote = text[i];
  const std::string triple(3, quote);
  const bool spans = text.compare(i, 3, triple) == 0;
  for (i += spans ? 3 : 1; i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"') {
      ++i;
    } else if (spans && text.compare(i, 3, triple) == 0) {
      i += 3;
      while (i < text.size() && text[i] == quote) ++i; // quotes may stand before the closing ones
      return i;
    } else if (!spans && (text[i] == quote || text[i] == '\n')) {
      return text[i] == quote ? i + 1 : i;
    }
  }
  return text.size();
}

/// The parser recurses over dotted keys, so that megabytes of "a.a.a" would exhaust the stack. A key is what stands
/// between two of , = [ ] { } # and line ends; a number there has one dot, so long arrays pass.
void refuse_absurd(const std::string &text, const std::string &origin) {
  if (text.size() > max_bytes)
    throw InputError(fmt::format("{}: {} bytes; a scene has at most {}", origin, text.size(), max_bytes));
  if (const auto nul = text.find('\0'); nul != std::string::npos) // the parser asserts that none comes
    throw InputError(fmt::format("{}:{}: a NUL; it is no text file", origin,
                                 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(nul), '\n')));
  std::size_t line = 1;
  int dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      const std::size_t end = behind_string(text, i);
      line += static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(i),
                                                  text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
      i = end;
      continue;
    }
    if (c == '#') { // a comment, to the line's end
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (std::string_view(",=[]{}\n").find(c) != std::string_view::npos) dots = 0;
    line += c == '\n';
    if (c == '.' && ++dots > max_dots_a_key)
      throw InputError(fmt::format("{}:{}: more than {} dots in a key", origin, line, max_dots_a_key));
    ++i;
  }
}

/// Digits, a comma and digits where a value stands: a decimal comma, or a thousands separator.
std::string hint_on_line(const std::string &text, std::size_t line_number) {
  const auto lines = lines_of(text);
  if (line_number == 0 || line_number > lines.size()) return {};
  const std::string line(lines[line_number - 1]);
  const auto value = trim(std::string_view(line).substr(line.find('=') + 1));
  return hint_at_comma(value.substr(0, value.find('#')));
}

toml::table parse(const std::string &text, const std::string &origin) {
  refuse_absurd(text, origin);
  try {
    return toml::parse(std::string_view(text), std::string_view(origin));
  } catch (const toml::parse_error &error) {
    const auto &at = error.source().begin;
    throw InputError(fmt::format("{}:{}:{}: {}{}", origin, at.line, at.column, std::string(error.description()),
                                 hint_on_line(text, at.line)));
  }
}

/// The entry of a list, its number followed by a bracket; null: there is none.
const toml::node *entry_of(const toml::node &list, std::string_view number) {
  std::size_t i = 0;
  const auto read = std::from_chars(number.data(), number.data() + number.size(), i);
  const auto *array = read.ec == std::errc() ? list.as_array() : nullptr;
  return array ? array->get(i) : nullptr;
}

std::string outer(const std::string &path) {
  const auto dot = path.rfind('.');
  return dot == std::string::npos ? "" : path.substr(0, dot);
}

} // namespace

TomlFile::TomlFile(const std::string &text, const std::string &origin)
    : origin_(origin), comments_(toml_comments(text)), root_(parse(text, origin)) {}

void TomlFile::set(const std::string &assignment, const std::string &place) {
  const std::string where = place.empty() ? "--set " + assignment : place;
  const auto equals = assignment.find('=');
  if (equals == std::string::npos || assignment.size() > 4096) throw InputError(where + ": must be KEY=VALUE");
  const std::string path(trim(std::string_view(assignment).substr(0, equals)));
  const std::string value(trim(std::string_view(assignment).substr(equals + 1)));
  const auto names = split(path, '.');
  for (const auto name : names)
    if (trim(name).empty() || names.size() > 8)
      throw InputError(where + ": KEY must be dotted names, e.g. rim.height_mm");
  toml::table parsed;
  try {
    parsed = parse("v = " + value, where);
  } catch (const InputError &) {
    parsed.clear(); // a bare word
  }
  if (parsed.size() != 1 || !parsed.contains("v")) {
    parsed.clear();
    parsed.insert_or_assign("v", value);
  }
  toml::table *table = &root_;
  for (std::size_t i = 0; i + 1 < names.size(); ++i) {
    const std::string_view name = trim(names[i]);
    if (!table->contains(name)) table->insert_or_assign(name, toml::table{});
    table = table->get(name)->as_table();
    if (!table) throw InputError(fmt::format("{}: {} is not a table", where, name));
  }
  table->insert_or_assign(trim(names.back()), std::move(*parsed.get("v")));
  overrides_[path] = {where, toml_comments("v = " + value).by_line[1]};
}

void TomlFile::erase(const std::string &path) {
  const auto *table = find(outer(path));
  if (!table || !table->is_table()) return;
  const_cast<toml::table *>(table->as_table())->erase(path.substr(path.rfind('.') + 1)); // root_ is this object's own
}

const toml::node *TomlFile::find(const std::string &path) const {
  const toml::node *node = &root_;
  if (path.empty()) return node;
  for (const auto part : split(path, '.')) {
    const auto bracket = part.find('[');
    const auto *table = node->as_table();
    node = table ? table->get(part.substr(0, bracket)) : nullptr;
    if (node && bracket != std::string_view::npos) node = entry_of(*node, part.substr(bracket + 1));
    if (!node) return nullptr;
  }
  return node;
}

std::string TomlFile::location(const std::string &path) const {
  if (const auto found = overrides_.find(path); found != overrides_.end()) return found->second.place;
  const toml::node *node = find(path);
  if (node && node->source().begin.line > 0)
    return fmt::format("{}:{}:{}", origin_, node->source().begin.line, node->source().begin.column);
  // A table that only an override brought into being.
  for (const auto &[key, typed] : overrides_)
    if (node && key.compare(0, path.size() + 1, path + ".") == 0) return typed.place;
  return origin_;
}

std::string TomlFile::location_of_key(const std::string &path, const toml::key &key) const {
  if (key.source().begin.line == 0 || overrides_.count(path)) return location(path);
  return fmt::format("{}:{}:{}", origin_, key.source().begin.line, key.source().begin.column);
}

const TomlFile::Typed *TomlFile::typed(const std::string &path) const {
  for (std::string name = path; !name.empty(); name = outer(name))
    if (const auto found = overrides_.find(name); found != overrides_.end()) return &found->second;
  return nullptr;
}

bool TomlFile::is_set(const std::string &path) const {
  return typed(path) != nullptr;
}

std::string TomlFile::comment_of(const std::string &path) const {
  if (const auto *override = typed(path)) return override->comment;
  const toml::node *node = find(path);
  const auto found = comments_.by_line.find(node ? node->source().end.line : 0);
  return found == comments_.by_line.end() ? "" : found->second;
}

std::string TomlFile::comment_of_table(const std::string &path) const {
  const toml::node *table = typed(path) ? nullptr : find(outer(path));
  const std::size_t line = table ? table->source().begin.line : 0;
  const auto found = comments_.by_line.find(line);
  return found == comments_.by_line.end() || comments_.headers.count(line) == 0 ? "" : found->second;
}

} // namespace rimpact

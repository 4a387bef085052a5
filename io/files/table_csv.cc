#include "io/files/table_csv.h"

#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/text.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact {
namespace {

std::string quoted(const std::string &text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c == '\n' || c == '\r' ? ' ' : c; // one row, one line
  }
  return result + "\"";
}

std::string text_of(const Cell &cell) {
  if (const auto *text = std::get_if<std::string>(&cell)) return quoted(*text);
  const auto *number = std::get_if<double>(&cell);
  if (!number) return "";
  if (!std::isfinite(*number)) throw std::logic_error("a table cell that is not finite");
  return fmt::format("{}", *number);
}

/// A column's name as it stands in the header: in quotes where it holds a comma or a quote.
std::string name_of(const std::string &column) {
  return column.find_first_of(",\"\n\r") == std::string::npos ? column : quoted(column);
}

/// What stands from `at` to the next comma, `at` moves behind it.
std::string_view bare(std::string_view line, std::size_t &at) {
  const auto end = std::min(line.find(',', at), line.size());
  const auto text = line.substr(at, end - at);
  at = end + 1;
  return text;
}

/// The text of quotes that open at `at`, which moves behind their comma.
std::string unquoted(std::string_view line, std::size_t &at, const std::string &place) {
  std::string text;
  for (++at; at < line.size(); ++at) {
    if (line[at] != '"') {
      text += line[at];
      continue;
    }
    if (at + 1 < line.size() && line[at + 1] == '"') {
      text += '"', ++at;
      continue;
    }
    at += 2;
    return text;
  }
  throw DataError(fmt::format("{}: a quote is not closed", place));
}

bool opens_quotes(std::string_view line, std::size_t at) {
  return at < line.size() && line[at] == '"';
}

/// The next cell of a line from `at` on, which moves behind its comma.
Cell next_cell(std::string_view line, std::size_t &at, const std::string &place) {
  if (opens_quotes(line, at)) return unquoted(line, at, place);
  const auto text = bare(line, at);
  if (text.empty()) return {};
  const auto number = to_number(text);
  if (!number || !std::isfinite(*number))
    throw DataError(fmt::format("{}: \"{}\" is no number", place, text.substr(0, 80)));
  return *number;
}

std::vector<std::string> names_of(std::string_view header, const std::string &place) {
  std::vector<std::string> names;
  for (std::size_t at = 0; at <= header.size();)
    names.push_back(opens_quotes(header, at) ? unquoted(header, at, place) : std::string(bare(header, at)));
  return names;
}

} // namespace

void write_csv(const Table &table, const std::string &path) {
  std::string out;
  for (std::size_t i = 0; i < table.columns.size(); ++i) out += (i ? "," : "") + name_of(table.columns[i]);
  out += '\n';
  for (const auto &row : table.rows) {
    if (row.size() != table.columns.size()) throw std::logic_error("a table row of another length");
    for (std::size_t i = 0; i < row.size(); ++i) out += (i ? "," : "") + text_of(row[i]);
    out += '\n';
  }
  write_atomically(out, path);
}

Table read_table(const std::string &path) {
  const std::string text = read_file(path);
  const auto lines = lines_of(text);
  if (lines.empty()) throw DataError(fmt::format("{}: is empty, a line of column names is needed", path));
  Table table;
  table.columns = names_of(lines[0], path + ":1");
  for (std::size_t n = 1; n < lines.size(); ++n) {
    if (lines[n].empty()) continue;
    const std::string place = fmt::format("{}:{}", path, n + 1);
    std::vector<Cell> row;
    std::size_t at = 0;
    while (row.size() < table.columns.size() && at <= lines[n].size()) row.push_back(next_cell(lines[n], at, place));
    if (row.size() != table.columns.size() || at <= lines[n].size())
      throw DataError(fmt::format("{}: the line has not {} cells", place, table.columns.size()));
    table.rows.push_back(std::move(row));
  }
  return table;
}

} // namespace rimpact

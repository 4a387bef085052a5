#include "scene/error.h"
#include "scene/files.h"
#include "scene/table.h"
#include "scene/text.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact::scene {
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

/// The next cell of a line from `at` on, which moves behind its comma.
Cell next_cell(std::string_view line, std::size_t &at, const std::string &place) {
  if (at >= line.size() || line[at] != '"') {
    const auto end = std::min(line.find(',', at), line.size());
    const auto text = line.substr(at, end - at);
    at = end + 1;
    if (text.empty()) return {};
    const auto number = to_number(text);
    if (!number || !std::isfinite(*number))
      throw DataError(fmt::format("{}: \"{}\" is no number", place, text.substr(0, 80)));
    return *number;
  }
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

} // namespace

void write_csv(const Table &table, const std::string &path) {
  std::string out;
  for (std::size_t i = 0; i < table.columns.size(); ++i) out += (i ? "," : "") + table.columns[i];
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
  for (const auto name : split(lines[0], ',')) table.columns.emplace_back(name);
  for (std::size_t n = 1; n < lines.size(); ++n) {
    if (lines[n].empty()) continue;
    const std::string place = fmt::format("{}:{}", path, n + 1);
    std::vector<Cell> row;
    std::size_t at = 0;
    while (row.size() < table.columns.size() && at <= lines[n].size())
      row.push_back(next_cell(lines[n], at, place));
    if (row.size() != table.columns.size() || at <= lines[n].size())
      throw DataError(fmt::format("{}: the line has not {} cells", place, table.columns.size()));
    table.rows.push_back(std::move(row));
  }
  return table;
}

} // namespace rimpact::scene

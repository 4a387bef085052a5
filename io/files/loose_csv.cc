#include "io/files/loose_csv.h"
#include "io/files/binary_kind.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact {
namespace {

bool holds(const std::vector<std::string> &cells, const std::string &name) {
  return std::find(cells.begin(), cells.end(), name) != cells.end();
}

} // namespace

LooseTable::LooseTable(const std::string &bytes, const std::string &path, const std::vector<std::string> &columns)
    : path_(path) {
  refuse_binary(bytes, path);
  const std::string text = utf8_text(bytes, path);
  const auto lines = lines_of(text);
  char separator = 0;
  std::size_t at = 0;
  for (; at < lines.size() && separator == 0; ++at)
    for (const char candidate : {',', ';', '\t'}) {
      const auto cells = cells_of(lines[at], candidate);
      if (!std::all_of(columns.begin(), columns.end(), [&](const auto &name) { return holds(cells, name); })) continue;
      columns_ = cells, separator = candidate;
      break;
    }
  if (separator == 0) throw DataError(fmt::format("{}: no line has the columns {}", path, fmt::join(columns, ", ")));
  for (; at < lines.size() && !trim(lines[at]).empty(); ++at) {
    LooseRow row{at + 1, cells_of(lines[at], separator)};
    while (row.cells.size() > columns_.size() && row.cells.back().empty()) row.cells.pop_back(); // commas at the end
    if (row.cells.size() != columns_.size())
      throw DataError(fmt::format("{}:{}: {} cells, the header has {}{}", path, at + 1, row.cells.size(),
                                  columns_.size(),
                                  separator == ',' ? "; with decimal commas, semicolons must separate the cells" : ""));
    rows_.push_back(std::move(row));
  }
  if (rows_.empty()) throw DataError(fmt::format("{}: the table has no rows below its header", path));
}

bool LooseTable::has(const std::string &column) const {
  return holds(columns_, column);
}

std::size_t LooseTable::place(const std::string &column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end()) throw DataError(fmt::format("{}: has no column {}", path_, column));
  return static_cast<std::size_t>(found - columns_.begin());
}

const std::string &LooseTable::text(const LooseRow &row, const std::string &column) const {
  return row.cells[place(column)];
}

double LooseTable::number(const LooseRow &row, const std::string &column) const {
  const std::string &cell = text(row, column);
  const auto value = decimals_.number(cell, fmt::format("{}:{}: {}", path_, row.line, column));
  if (!value)
    throw DataError(
        fmt::format("{}:{}: {} \"{}\" is not a finite number", path_, row.line, column, cell.substr(0, 40)));
  return *value;
}

} // namespace rimpact

#include "io/files/table_lines.h"

#include "io/files/binary_kind.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact {

std::vector<TableLine> table_lines(std::string_view text, const std::string &path) {
  refuse_binary(text, path);
  std::vector<TableLine> lines;
  std::size_t number = 0;
  for (const auto line : lines_of(text)) {
    ++number;
    if (!trim(line).empty() && trim(line).front() != '#') lines.push_back({line, fmt::format("{}:{}", path, number)});
  }
  return lines;
}

double finite_number(std::string_view cell, const std::string &where) {
  const auto value = to_number(cell);
  if (!value || !std::isfinite(*value))
    throw DataError(fmt::format("{}: \"{}\" is not a finite number", where, trim(cell).substr(0, 40)));
  return *value;
}

} // namespace rimpact

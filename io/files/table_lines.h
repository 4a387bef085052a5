/// What the readers of comma-separated tables have in common: lines and numbers, each with its place for messages.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace rimpact {

struct TableLine {
  std::string_view text;
  std::string where; ///< "path:line"
};
/// The lines of `text`, which must outlive them, but for empty ones and comments, which begin with #.
std::vector<TableLine> table_lines(std::string_view text, const std::string &path);

/// Throws DataError naming the place and the cell.
double finite_number(std::string_view cell, const std::string &where);

} // namespace rimpact

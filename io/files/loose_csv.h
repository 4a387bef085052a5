/// CSV as spreadsheets and data bases write it: any of comma, semicolon and tab between cells, quotes, lines of remarks
/// above the header. UTF-8 with and without a byte-order mark or UTF-16; decimal commas where commas do not separate
/// cells.
#pragma once
#include "io/files/loose_cells.h"
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rimpact {

struct LooseRow {
  std::size_t line; ///< from 1
  std::vector<std::string> cells;
};

class LooseTable {
public:
  /// The header is the first line that holds every name of `columns` as a cell. Rows end at the file's end or at the
  /// first empty line below the header. Throws DataError naming the columns that no line has, or a row's line and
  /// number of cells.
  LooseTable(const std::string &bytes, const std::string &path, const std::vector<std::string> &columns);

  const std::vector<LooseRow> &rows() const { return rows_; }
  bool has(const std::string &column) const;
  const std::string &text(const LooseRow &row, const std::string &column) const;
  /// Throws DataError naming line, column and word where it is no finite number, or has a decimal point where numbers
  /// asked for before had a comma.
  double number(const LooseRow &row, const std::string &column) const;

private:
  std::size_t place(const std::string &column) const;
  std::string path_;
  std::vector<std::string> columns_;
  std::vector<LooseRow> rows_;
  mutable DecimalReader decimals_; ///< what the numbers asked for so far had
};

} // namespace rimpact

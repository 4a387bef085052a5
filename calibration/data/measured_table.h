/// A laboratory's table. Between cells stands any of comma, semicolon and tab; text may stand above the names of the
/// columns and below the rows. Units may have a row of their own, decimals a comma, letters another character set, and
/// several tables may lie under one another.
#pragma once
#include "io/files/loose_cells.h"
#include <optional>
#include <string>
#include <vector>

namespace rimpact::calibration {

/// Where a table lies within its file.
struct TableForm {
  std::string encoding;           ///< empty: UTF-8, UTF-16, or the set that gives `names`
  int skip_lines = 0;             ///< 0: the header is the first line that holds all `names`
  int block = 0;                  ///< of the parts that begin with a header, from 1; 0: the first header to the end
  std::vector<std::string> names; ///< of the columns that are wanted
};

class MeasuredTable {
public:
  /// Throws DataError naming file, line and what stands there; InputError for a character set that is not known.
  MeasuredTable(const std::string &bytes, const std::string &path, const TableForm &form);

  const std::string &path() const { return path_; }
  std::size_t size() const { return rows_.size(); }
  bool has(const std::string &column) const;
  const std::vector<std::string> &header() const { return header_; }
  const std::string &text(std::size_t row, const std::string &column) const;
  /// Throws DataError naming the line and the word where it is no finite number.
  double number(std::size_t row, const std::string &column) const;
  std::size_t line(std::size_t row) const { return rows_[row].line; }
  /// As the row of units below the names says, else brackets in the name; empty: neither does.
  std::string unit(const std::string &column) const;
  /// What was found and decided by itself: a decimal comma, a character set, lines left out.
  std::vector<std::string> notes() const;

private:
  struct Row {
    std::size_t line; ///< from 1
    std::vector<std::string> cells;
  };
  void take_units(const std::vector<std::string> &names);
  void leave_out_footer(const std::vector<std::string> &names);
  /// How many of the names are cells of the line.
  static std::size_t names_in(std::string_view line, char separator, const std::vector<std::string> &names);
  bool has_number(const Row &row, const std::vector<std::string> &names) const;
  std::size_t place(const std::string &column) const;

  using Lines = std::vector<std::string_view>;
  std::size_t find_header(const Lines &lines, const TableForm &form);
  void read_rows(const Lines &lines, std::size_t first, const TableForm &form);

  std::string path_;
  char separator_ = ',';
  std::vector<std::string> header_, units_, notes_;
  std::vector<Row> rows_;
  mutable DecimalReader decimals_;
};

/// A unit as mappings write it from what stands in a table, as "[mm/s]": brackets off, "/" as "_per_".
std::string unit_as_mapped(std::string written);

} // namespace rimpact::calibration

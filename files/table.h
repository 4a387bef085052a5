/// A table: named columns, each cell a number, a text or empty. Written as CSV and HDF5, read from CSV.
#pragma once
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rimpact {

/// Empty, a finite number, or a text.
using Cell = std::variant<std::monostate, double, std::string>;

struct Table {
  std::vector<std::string> columns; ///< names, with the unit at their end: peak_displacement_m
  std::vector<std::vector<Cell>> rows;
  std::map<std::string, std::string> meta; ///< texts for /meta of the HDF5 file
};

/// Written atomically. Numbers stand with all their digits, texts in quotes, empty cells are empty.
/// Throws IoError; std::logic_error for a row of another length or a number that is not finite.
void write_csv(const Table &table, const std::string &path);
/// Reads what write_csv writes. Throws DataError naming file and line.
Table read_table(const std::string &path);
/// /table/NAME: one dataset a column, packed, so that a reader takes the columns and rows it asks for: numbers (f64; an
/// empty cell is NaN), or texts of UTF-8 of one length, padded with zeros, in a column that holds any (an empty cell is
/// an empty text).
void write_hdf5(const Table &table, const std::string &path);

/// What write_hdf5 makes of a table.
struct TableShape {
  std::size_t n_rows = 0;
  /// In the table's order; the bytes of its texts, 0: a column of numbers.
  std::vector<std::pair<std::string, std::size_t>> columns;
};
TableShape shape_of(const Table &table);

} // namespace rimpact

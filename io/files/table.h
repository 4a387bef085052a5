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

/// What write_hdf5 makes of a table.
struct TableShape {
  std::size_t n_rows = 0;
  /// In the table's order; the bytes of its texts, 0: a column of numbers.
  std::vector<std::pair<std::string, std::size_t>> columns;
};
TableShape shape_of(const Table &table);

} // namespace rimpact

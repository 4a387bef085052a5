/// A table: named columns, each cell a number, a text or empty. Written as CSV and HDF5, read from CSV.
#pragma once
#include <map>
#include <string>
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
/// /table/NAME: one dataset a column, of numbers (f64) or of texts (a column that holds any text); in a
/// column with empty cells these are 0 or "" and /present/NAME says which are there (1) and which are not
/// (0).
void write_hdf5(const Table &table, const std::string &path);

} // namespace rimpact

/// Tables as CSV files.
#pragma once
#include "io/files/table.h"

namespace rimpact {

/// Written atomically. Numbers stand with all their digits, texts in quotes, empty cells are empty.
/// Throws IoError; std::logic_error for a row of another length or a number that is not finite.
void write_csv(const Table &table, const std::string &path);
/// Reads what write_csv writes. Throws DataError naming file and line.
Table read_table(const std::string &path);

} // namespace rimpact

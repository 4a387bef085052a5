/// Responses as CSV files.
#pragma once
#include "responses/response.h"
#include <optional>
#include <string_view>

namespace rimpact {

/// A column of response.csv: its name is symbol_unit.
struct CsvColumn {
  const char *symbol, *unit, *signal;
  bool written; ///< false: read where it is there, never written
};

/// A unit as column names and mappings write it: times `factor` it is `base` (s, m, N or m_per_s).
struct CsvUnit {
  const char *name, *base;
  double factor;
};

const std::vector<CsvColumn> &csv_columns();
std::string csv_units_of(std::string_view base); ///< their names, e.g. "s, ms"
std::optional<CsvUnit> csv_unit(std::string_view name);
/// Throws DataError; `path` is for messages only.
Response parse_csv(const std::string &text, const std::string &path);

void write_csv(const Response &response, const std::string &path); ///< time_s,ux_m,...,gap_m

} // namespace rimpact

/// The two file forms of a response, from and to bytes.
#pragma once
#include "responses/response.h"
#include <optional>
#include <string>
#include <string_view>

namespace rimpact {

/// Throw DataError; `path` is for messages only.
Response parse_hdf5(const std::string &bytes, const std::string &path);
Response parse_csv(const std::string &text, const std::string &path);

/// A column of response.csv: its name is symbol_unit.
struct CsvColumn {
  const char *symbol, *unit, *signal;
  bool written; ///< false: read where it is there, never written
};
const std::vector<CsvColumn> &csv_columns();

/// A unit as column names and mappings write it: times `factor` it is `base` (s, m, N or m_per_s).
struct CsvUnit {
  const char *name, *base;
  double factor;
};
std::optional<CsvUnit> csv_unit(std::string_view name);
std::string csv_units_of(std::string_view base); ///< their names, e.g. "s, ms"

} // namespace rimpact

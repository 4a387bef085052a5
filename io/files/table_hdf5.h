/// Tables as HDF5 files.
#pragma once
#include "io/files/table.h"

namespace rimpact {

/// /table/NAME: one dataset a column, packed, so that a reader takes the columns and rows it asks for: numbers (f64; an
/// empty cell is NaN), or texts of UTF-8 of one length, padded with zeros, in a column that holds any (an empty cell is
/// an empty text).
void write_hdf5(const Table &table, const std::string &path);

} // namespace rimpact

/// Columns of tables in HDF5: one-dimensional datasets, packed, of which a reader takes what it asks for.
#pragma once
#include "io/files/hdf5_memory.h"
#include <functional>

namespace rimpact::hdf5 {

/// Numbers (f64). Columns of more than a thousand rows are packed (shuffle, deflate), in pieces of 16,384.
void write_number_column(hid_t group, const std::string &name, const std::vector<double> &values);
/// `n` texts of at most `width` bytes of UTF-8, shorter ones padded with zeros; packed the same way.
void write_text_column(hid_t group, const std::string &name, std::size_t n, std::size_t width,
                       const std::function<std::string(std::size_t)> &text);

/// Rows of a column that stand in another file.
struct ColumnPart {
  std::string file; ///< beside the file that is written
  std::size_t first, count;
};
/// A column of `n` rows whose parts are read where they stand when it is read (a virtual dataset); rows of no part are
/// NaN, or an empty text. `width`: of texts, 0: numbers. The parts' datasets have the path `dataset`.
void write_virtual_column(hid_t group, const std::string &name, std::size_t n, std::size_t width,
                          const std::string &dataset, const std::vector<ColumnPart> &parts);

} // namespace rimpact::hdf5

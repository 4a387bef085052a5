/// Many tables as one, without a copy of them.
#pragma once
#include "io/files/table.h"
#include <map>
#include <string>
#include <vector>

namespace rimpact {

/// Tables that write_hdf5 has written, one behind the other: a file of a few kilobytes whose columns are read where
/// they stand when they are read (HDF5's virtual datasets). Each table's rows get columns of its own in front.
class GatheredTable {
public:
  /// `keys`: names of those columns; they take the place of a table's of the same name.
  explicit GatheredTable(std::vector<std::string> keys = {}) : keys_(std::move(keys)) {}
  /// `file`: of write_hdf5, beside the gathered one; `values`: one a key, of every row of it.
  void add(const std::string &file, const TableShape &shape, const std::vector<Cell> &values);
  std::size_t n_rows() const { return n_rows_; }
  /// /table/NAME as write_hdf5 has it: a column that a table has not is NaN or empty in its rows, and so is one that is
  /// numbers there and texts elsewhere. Written atomically. Throws IoError.
  void write(const std::string &path, const std::map<std::string, std::string> &meta) const;

  struct Part {
    std::string file;
    TableShape shape;
    std::vector<Cell> values;
    std::size_t first; ///< row
  };

private:
  std::vector<std::string> keys_;
  std::vector<Part> parts_;
  std::size_t n_rows_ = 0;
};

} // namespace rimpact

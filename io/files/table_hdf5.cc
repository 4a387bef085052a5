#include "io/files/table_hdf5.h"

#include "io/files/file.h"
#include "io/files/hdf5_column.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace rimpact {

using namespace hdf5;

namespace {

double as_number(const Cell &cell) {
  const auto *number = std::get_if<double>(&cell);
  if (number && !std::isfinite(*number)) throw std::logic_error("a table cell that is not finite");
  return number ? *number : std::numeric_limits<double>::quiet_NaN();
}

std::string as_text(const Cell &cell) {
  const auto *text = std::get_if<std::string>(&cell);
  return text ? *text : "";
}

} // namespace

TableShape shape_of(const Table &table) {
  TableShape shape{.n_rows = table.rows.size(), .columns = {}};
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    std::size_t width = 0;
    for (const auto &row : table.rows)
      if (const auto *text = std::get_if<std::string>(&row.at(i)))
        width = std::max({width, text->size(), std::size_t{1}}); // HDF5 has no texts of no bytes
    shape.columns.emplace_back(table.columns[i], width);
  }
  return shape;
}

void write_hdf5(const Table &table, const std::string &path) {
  const TableShape shape = shape_of(table);
  const std::string bytes = file_in_memory([&](hid_t file) {
    const Handle group(H5Gcreate2(file, "table", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, "group");
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const auto &[name, width] = shape.columns[i];
      if (width > 0) {
        write_text_column(group, name, shape.n_rows, width,
                          [&](std::size_t row) { return as_text(table.rows[row][i]); });
        continue;
      }
      std::vector<double> values;
      values.reserve(shape.n_rows);
      for (const auto &row : table.rows) values.push_back(as_number(row[i]));
      write_number_column(group, name, values);
    }
    write_meta(file, table.meta);
  });
  write_atomically(bytes, path);
}

} // namespace rimpact

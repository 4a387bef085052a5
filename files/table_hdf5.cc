#include "files/file.h"
#include "files/hdf5_memory.h"
#include "files/table.h"
#include <algorithm>
#include <cmath>

namespace rimpact {

using namespace hdf5;

namespace {

std::string as_text(const Cell &cell) {
  const auto *text = std::get_if<std::string>(&cell);
  return text ? *text : "";
}

double as_number(const Cell &cell) {
  const auto *number = std::get_if<double>(&cell);
  if (number && !std::isfinite(*number)) throw std::logic_error("a table cell that is not finite");
  return number ? *number : 0.0;
}

void write_column(hid_t group, hid_t present, const Table &table, std::size_t i) {
  bool has_text = false, has_empty = false;
  std::vector<double> there;
  for (const auto &row : table.rows) {
    has_text |= std::holds_alternative<std::string>(row.at(i));
    there.push_back(std::holds_alternative<std::monostate>(row[i]) ? 0 : 1);
    has_empty |= there.back() == 0;
  }
  const auto column = [&](const auto &convert) {
    std::vector<decltype(convert(Cell{}))> values;
    values.reserve(table.rows.size());
    for (const auto &row : table.rows) values.push_back(convert(row[i]));
    return values;
  };
  if (has_text)
    write_strings(group, table.columns[i], column(as_text));
  else
    write_numbers(group, table.columns[i], column(as_number));
  if (has_empty) write_numbers(present, table.columns[i], there);
}

} // namespace

void write_hdf5(const Table &table, const std::string &path) {
  const std::string bytes = file_in_memory([&](hid_t file) {
    const Handle group(H5Gcreate2(file, "table", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, "group");
    const Handle present(H5Gcreate2(file, "present", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, "group");
    for (std::size_t i = 0; i < table.columns.size(); ++i) write_column(group, present, table, i);
    write_meta(file, table.meta);
  });
  write_atomically(bytes, path);
}

} // namespace rimpact

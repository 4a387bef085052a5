#include "io/files/gathered_table.h"
#include "io/files/file.h"
#include "io/files/hdf5_column.h"
#include <algorithm>
#include <limits>

namespace rimpact {

using namespace hdf5;

namespace {

using Parts = std::vector<GatheredTable::Part>;

/// The column of a part's own value number `key`, in every row of it.
void write_key(hid_t group, const std::string &name, const Parts &parts, std::size_t key) {
  Table own{{name}, {}, {}};
  std::vector<std::size_t> part_of; // of each row
  for (std::size_t i = 0; i < parts.size(); ++i) {
    own.rows.push_back({parts[i].values.at(key)});
    part_of.insert(part_of.end(), parts[i].shape.n_rows, i);
  }
  if (const std::size_t width = shape_of(own).columns[0].second; width > 0)
    return write_text_column(group, name, part_of.size(), width, [&](std::size_t row) {
      const auto *text = std::get_if<std::string>(&parts[part_of[row]].values[key]);
      return text ? *text : std::string();
    });
  std::vector<double> values;
  for (const auto &part : parts) {
    const auto *number = std::get_if<double>(&part.values[key]);
    values.insert(values.end(), part.shape.n_rows, number ? *number : std::numeric_limits<double>::quiet_NaN());
  }
  write_number_column(group, name, values);
}

/// Where the parts have a column of this name and kind.
std::vector<ColumnPart> where(const Parts &parts, const std::string &name, bool is_text) {
  std::vector<ColumnPart> found;
  for (const auto &part : parts) {
    const auto has = [&](const auto &column) { return column.first == name && (column.second > 0) == is_text; };
    if (part.shape.n_rows > 0 && std::any_of(part.shape.columns.begin(), part.shape.columns.end(), has))
      found.push_back({part.file, part.first, part.shape.n_rows});
  }
  return found;
}

} // namespace

void GatheredTable::add(const std::string &file, const TableShape &shape, const std::vector<Cell> &values) {
  parts_.push_back({file, shape, values, n_rows_});
  n_rows_ += shape.n_rows;
}

void GatheredTable::write(const std::string &path, const std::map<std::string, std::string> &meta) const {
  std::map<std::string, std::size_t> widths; // the widest of each name
  for (const auto &part : parts_)
    for (const auto &[name, width] : part.shape.columns) widths[name] = std::max(widths[name], width);
  for (const auto &key : keys_) widths.erase(key);
  const std::string bytes = file_in_memory([&](hid_t file) {
    const Handle group(H5Gcreate2(file, "table", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, "group");
    for (std::size_t key = 0; key < keys_.size(); ++key) write_key(group, keys_[key], parts_, key);
    for (const auto &[name, width] : widths)
      write_virtual_column(group, name, n_rows_, width, "/table/" + name, where(parts_, name, width > 0));
    write_meta(file, meta);
  });
  write_atomically(bytes, path);
}

} // namespace rimpact

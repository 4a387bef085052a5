#include "io/files/hdf5_column.h"
#include <algorithm>
#include <limits>

namespace rimpact::hdf5 {
namespace {

constexpr hsize_t piece = 16384, least_packed = 1000;

Handle row_space(std::size_t n) {
  const hsize_t rows = n;
  return {H5Screate_simple(1, &rows, nullptr), H5Sclose, "space"};
}

Handle new_properties() {
  return {H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "dataset properties"};
}

void pack(hid_t properties, std::size_t n) {
  if (n <= least_packed || H5Zfilter_avail(H5Z_FILTER_DEFLATE) <= 0) return;
  const hsize_t rows = std::min<hsize_t>(piece, n);
  check(H5Pset_chunk(properties, 1, &rows), "pieces");
  check(H5Pset_shuffle(properties), "shuffle");
  check(H5Pset_deflate(properties, 1), "deflate");
}

Handle new_set(hid_t group, const std::string &name, hid_t type, hid_t space, hid_t properties) {
  return {H5Dcreate2(group, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose, "column"};
}

/// Of texts of `width` bytes.
Handle text_type(std::size_t width) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  const bool is_made = type >= 0 && H5Tset_size(type, width) >= 0 && H5Tset_strpad(type, H5T_STR_NULLPAD) >= 0 &&
                       H5Tset_cset(type, H5T_CSET_UTF8) >= 0;
  return {is_made ? type : -1, H5Tclose, "text type"};
}

} // namespace

void write_number_column(hid_t group, const std::string &name, const std::vector<double> &values) {
  const Handle space = row_space(values.size()), properties = new_properties();
  pack(properties, values.size());
  const Handle set = new_set(group, name, H5T_IEEE_F64LE, space, properties);
  if (!values.empty()) check(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "values");
}

void write_text_column(hid_t group, const std::string &name, std::size_t n, std::size_t width,
                       const std::function<std::string(std::size_t)> &text) {
  const Handle type = text_type(width), space = row_space(n), properties = new_properties();
  pack(properties, n);
  const Handle set = new_set(group, name, type, space, properties);
  for (hsize_t first = 0; first < n; first += piece) { // by pieces: one long text makes every row wide
    const hsize_t rows = std::min<hsize_t>(piece, n - first);
    std::string bytes(rows * width, '\0');
    for (hsize_t i = 0; i < rows; ++i) text(first + i).copy(bytes.data() + i * width, width);
    const Handle there(H5Scopy(space), H5Sclose, "rows"), here = row_space(rows);
    check(H5Sselect_hyperslab(there, H5S_SELECT_SET, &first, nullptr, &rows, nullptr), "rows");
    check(H5Dwrite(set, type, here, there, H5P_DEFAULT, bytes.data()), "texts");
  }
}

void write_virtual_column(hid_t group, const std::string &name, std::size_t n, std::size_t width,
                          const std::string &dataset, const std::vector<ColumnPart> &parts) {
  const Handle space = row_space(n), properties = new_properties();
  const Handle type = width > 0 ? text_type(width) : Handle(H5Tcopy(H5T_IEEE_F64LE), H5Tclose, "number type");
  if (width == 0) {
    const double absent = std::numeric_limits<double>::quiet_NaN();
    check(H5Pset_fill_value(properties, H5T_NATIVE_DOUBLE, &absent), "fill value");
  }
  for (const auto &part : parts) {
    const hsize_t first = part.first, rows = part.count;
    const Handle here(H5Scopy(space), H5Sclose, "rows"), there = row_space(part.count);
    check(H5Sselect_hyperslab(here, H5S_SELECT_SET, &first, nullptr, &rows, nullptr), "rows");
    check(H5Pset_virtual(properties, here, part.file.c_str(), dataset.c_str(), there), "part of a column");
  }
  const Handle set = new_set(group, name, type, space, properties);
}

} // namespace rimpact::hdf5

#include "io/files/hdf5_memory.h"

#include <algorithm>

namespace rimpact::hdf5 {
namespace {

Handle text_type() {
  return {H5Tcopy(H5T_C_S1), H5Tclose, "string type"};
}
void set_variable_utf8(hid_t type) {
  check(H5Tset_size(type, H5T_VARIABLE), "string size");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "string encoding");
}

} // namespace

std::mutex &library_lock() {
  static std::mutex lock;
  return lock;
}

void check(herr_t status, const char *what) {
  if (status < 0) throw std::runtime_error(what);
}

Quiet::Quiet() {
  H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}
Quiet::~Quiet() {
  H5Eset_auto2(H5E_DEFAULT, function_, data_);
}

void write_string(hid_t place, const std::string &name, const std::string &text, bool as_attribute) {
  const Handle type = text_type();
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "text space");
  if (as_attribute) {
    set_variable_utf8(type);
    const char *const pointer = text.c_str();
    const Handle attribute(H5Acreate2(place, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                           "attribute");
    check(H5Awrite(attribute, type, &pointer), "attribute");
    return;
  }
  // Of fixed length, and ASCII where it is: Octave reads no other.
  check(H5Tset_size(type, std::max<std::size_t>(1, text.size())), "string size");
  check(H5Tset_strpad(type, H5T_STR_NULLPAD), "string end");
  const bool is_ascii = std::all_of(text.begin(), text.end(), [](unsigned char c) { return c < 128; });
  check(H5Tset_cset(type, is_ascii ? H5T_CSET_ASCII : H5T_CSET_UTF8), "string encoding");
  const Handle set(H5Dcreate2(place, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
                   "text");
  check(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()), "text");
}

void write_numbers(hid_t place, const std::string &name, const std::vector<double> &values) {
  const hsize_t n = values.size();
  const Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose, "space");
  const Handle set(H5Dcreate2(place, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                   H5Dclose, "dataset");
  if (n > 0) check(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "values");
}

void write_meta(hid_t file, const std::map<std::string, std::string> &meta) {
  const Handle group(H5Gcreate2(file, "meta", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, "group");
  for (const auto &[name, text] : meta) write_string(group, name, text, false);
}

std::string file_in_memory(const std::function<void(hid_t file)> &write) {
  const std::lock_guard guard(library_lock());
  const Quiet quiet;
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "access list");
  check(H5Pset_fapl_core(access, 1 << 20, false), "memory driver");
  const Handle file(H5Fcreate("file in memory", H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose, "file");
  write(file);
  check(H5Fflush(file, H5F_SCOPE_GLOBAL), "flush");
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  if (size < 0) throw std::runtime_error("file image");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (H5Fget_file_image(file, bytes.data(), bytes.size()) < 0) throw std::runtime_error("file image");
  return bytes;
}

namespace {

/// A file received from others must not make the program read further ones: no links, no external or virtual storage.
void refuse_other_files(hid_t group, const std::string &name) {
  H5L_info_t link;
  check(H5Lget_info(group, name.c_str(), &link, H5P_DEFAULT), "cannot be found");
  if (link.type != H5L_TYPE_HARD) throw std::runtime_error("is a link, values are needed");
  const Handle set(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, "cannot be opened");
  const Handle made(H5Dget_create_plist(set), H5Pclose, "has no properties");
  if (H5Pget_external_count(made) > 0 || H5Pget_layout(made) == H5D_VIRTUAL)
    throw std::runtime_error("keeps its values in another file");
}

/// A scalar string dataset, of fixed or variable length; empty when it is something else.
std::string read_string(hid_t group, const std::string &name) {
  const Handle set(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, "text");
  const Handle type(H5Dget_type(set), H5Tclose, "text type");
  const Handle space(H5Dget_space(set), H5Sclose, "text space");
  if (H5Tget_class(type) != H5T_STRING || H5Sget_simple_extent_npoints(space) != 1) return {};
  if (H5Tis_variable_str(type) > 0) {
    char *text = nullptr;
    check(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, &text), "text");
    std::string result = text ? text : "";
    H5Dvlen_reclaim(type, space, H5P_DEFAULT, &text);
    return result;
  }
  std::string text(H5Tget_size(type) + 1, '\0');
  check(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), "text");
  text.resize(text.find('\0')); // padded with zeros
  return text;
}

std::vector<std::string> names_in(hid_t group) {
  std::vector<std::string> names;
  const auto collect = [](hid_t, const char *name, const H5L_info_t *, void *list) -> herr_t {
    static_cast<std::vector<std::string> *>(list)->emplace_back(name);
    return 0;
  };
  check(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names), "group");
  return names;
}

} // namespace

bool exists(hid_t place, const char *name) {
  return H5Lexists(place, name, H5P_DEFAULT) > 0;
}

std::vector<double> read_numbers(hid_t group, const std::string &name) {
  refuse_other_files(group, name);
  const Handle set(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, "cannot be opened");
  const Handle space(H5Dget_space(set), H5Sclose, "has no extent");
  const Handle type(H5Dget_type(set), H5Tclose, "has no type");
  if (H5Sget_simple_extent_ndims(space) != 1) throw std::runtime_error("is not one-dimensional");
  const auto kind = H5Tget_class(type);
  if (kind != H5T_FLOAT && kind != H5T_INTEGER) throw std::runtime_error("does not hold numbers");
  const hssize_t n = H5Sget_simple_extent_npoints(space);
  if (n < 0 || n > 200'000'000) throw std::runtime_error("has an impossible length");
  std::vector<double> values(static_cast<std::size_t>(n));
  if (n > 0) check(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "is damaged");
  return values;
}

std::map<std::string, std::string> read_meta(hid_t file) {
  std::map<std::string, std::string> texts;
  if (!exists(file, "meta")) return texts;
  const Handle meta(H5Gopen2(file, "meta", H5P_DEFAULT), H5Gclose, "cannot open /meta");
  for (const auto &name : names_in(meta)) texts[name] = read_string(meta, name);
  return texts;
}

void with_image(const std::string &bytes, const std::function<void(hid_t file)> &read) {
  const std::lock_guard guard(library_lock());
  const Quiet quiet;
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "access list");
  check(H5Pset_fapl_core(access, 1 << 20, false), "memory driver");
  // The library only reads from its own copy of the image.
  check(H5Pset_file_image(access, const_cast<char *>(bytes.data()), bytes.size()), "file image");
  const Handle file(H5Fopen("in memory", H5F_ACC_RDONLY, access), H5Fclose, "damaged or truncated");
  read(file);
}

} // namespace rimpact::hdf5

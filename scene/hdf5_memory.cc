#include "scene/hdf5_memory.h"

namespace rimpact::scene::hdf5 {
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
  set_variable_utf8(type);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "text space");
  const char *const pointer = text.c_str();
  if (as_attribute) {
    const Handle attribute(H5Acreate2(place, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                           "attribute");
    check(H5Awrite(attribute, type, &pointer), "attribute");
    return;
  }
  const Handle set(H5Dcreate2(place, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                   H5Dclose, "text");
  check(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, &pointer), "text");
}

void write_strings(hid_t place, const std::string &name, const std::vector<std::string> &texts) {
  const Handle type = text_type();
  set_variable_utf8(type);
  const hsize_t n = texts.size();
  const Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose, "space");
  const Handle set(H5Dcreate2(place, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                   H5Dclose, "texts");
  std::vector<const char *> pointers;
  pointers.reserve(texts.size());
  for (const auto &text : texts) pointers.push_back(text.c_str());
  if (n > 0) check(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()), "texts");
}

void write_numbers(hid_t place, const std::string &name, const std::vector<double> &values) {
  const hsize_t n = values.size();
  const Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose, "space");
  const Handle set(
      H5Dcreate2(place, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
      "dataset");
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

} // namespace rimpact::scene::hdf5

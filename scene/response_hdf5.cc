/// HDF5 through its C interface, in memory: the library never sees a full disk (after a failed write it
/// cannot close its file), and the bytes go through the same atomic write as every other file.
#include "scene/error.h"
#include "scene/files.h"
#include "scene/response_files.h"
#include <fmt/format.h>
#include <hdf5.h>
#include <hdf5_hl.h>
#include <mutex>

namespace rimpact::scene {
namespace {

/// Debian's library is not thread safe; fleets of runs write from several threads.
std::mutex &library_lock() {
  static std::mutex lock;
  return lock;
}

/// An HDF5 identifier closed at the end of its scope; a negative one is a failure.
class Handle {
public:
  Handle(hid_t id, herr_t (*close)(hid_t), const char *what) : id_(id), close_(close) {
    if (id < 0) throw std::runtime_error(what);
  }
  ~Handle() { close_(id_); }
  Handle(const Handle &) = delete;
  Handle &operator=(const Handle &) = delete;
  operator hid_t() const { return id_; }

private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};
void check(herr_t status, const char *what) {
  if (status < 0) throw std::runtime_error(what);
}

/// Switches the library's own printing off; failures come back as codes.
class Quiet {
public:
  Quiet() {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Quiet() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }

private:
  H5E_auto2_t function_ = nullptr;
  void *data_ = nullptr;
};

/// Text of variable length, which every reader hands back as text.
void write_string(hid_t place, const std::string &name, const std::string &text, bool as_attribute) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "string type");
  check(H5Tset_size(type, H5T_VARIABLE), "string size");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "string encoding");
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

void write_signal(hid_t group, const SignalInfo &info, const std::vector<double> &values) {
  const hsize_t n = values.size();
  const Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose, "space");
  const Handle set(
      H5Dcreate2(group, info.name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose, "dataset");
  if (n > 0) check(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "values");
  write_string(set, "units", info.units, true);
  write_string(set, "description", info.description, true);
  if (info.name == "time") {
    check(H5DSset_scale(set, "time"), "dimension scale");
    return;
  }
  const Handle time(H5Dopen2(group, "time", H5P_DEFAULT), H5Dclose, "time");
  check(H5DSattach_scale(set, time, 0), "dimension scale");
}

std::string to_bytes(const Response &response) {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "access list");
  check(H5Pset_fapl_core(access, 1 << 20, false), "memory driver");
  const Handle file(H5Fcreate("response in memory", H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose, "file");
  {
    const Handle group(H5Gcreate2(file, "response", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
                       "group");
    for (const auto &info : known_signals())
      if (response.has(info.name)) write_signal(group, info, response.series(info.name));
    const Handle meta(H5Gcreate2(file, "meta", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, "group");
    for (const auto &[name, text] : response.meta) write_string(meta, name, text, false);
  }
  check(H5Fflush(file, H5F_SCOPE_GLOBAL), "flush");
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  if (size < 0) throw std::runtime_error("file image");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (H5Fget_file_image(file, bytes.data(), bytes.size()) < 0) throw std::runtime_error("file image");
  return bytes;
}

bool exists(hid_t place, const char *name) {
  return H5Lexists(place, name, H5P_DEFAULT) > 0;
}

std::vector<double> read_signal(hid_t group, const std::string &name) {
  const Handle set(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, "cannot be opened");
  const Handle space(H5Dget_space(set), H5Sclose, "has no extent");
  const Handle type(H5Dget_type(set), H5Tclose, "has no type");
  if (H5Sget_simple_extent_ndims(space) != 1) throw std::runtime_error("is not one-dimensional");
  const auto kind = H5Tget_class(type);
  if (kind != H5T_FLOAT && kind != H5T_INTEGER) throw std::runtime_error("does not hold numbers");
  const hssize_t n = H5Sget_simple_extent_npoints(space);
  if (n < 0 || n > 200'000'000) throw std::runtime_error("has an impossible length");
  std::vector<double> values(static_cast<std::size_t>(n));
  if (n > 0)
    check(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "is damaged");
  return values;
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
    const std::string result = text ? text : "";
    H5Dvlen_reclaim(type, space, H5P_DEFAULT, &text);
    return result;
  }
  std::string text(H5Tget_size(type) + 1, '\0');
  check(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), "text");
  return text.c_str();
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

Response from_image(hid_t file, const std::string &path) {
  if (!exists(file, "response")) throw DataError(fmt::format("{}: holds no group /response", path));
  Response response;
  const Handle group(H5Gopen2(file, "response", H5P_DEFAULT), H5Gclose, "cannot open /response");
  for (const auto &info : known_signals()) {
    if (!exists(group, info.name.c_str())) continue;
    try {
      response.series(info.name) = read_signal(group, info.name);
    } catch (const std::runtime_error &error) {
      throw DataError(fmt::format("{}: /response/{} {}", path, info.name, error.what()));
    }
  }
  if (!exists(file, "meta")) return response;
  const Handle meta(H5Gopen2(file, "meta", H5P_DEFAULT), H5Gclose, "cannot open /meta");
  for (const auto &name : names_in(meta)) response.meta[name] = read_string(meta, name);
  return response;
}

} // namespace

void write_hdf5(const Response &response, const std::string &path) {
  response.check();
  if (!response.has("time")) throw std::logic_error("a response without time");
  const std::string bytes = [&] {
    const std::lock_guard guard(library_lock());
    const Quiet quiet;
    return to_bytes(response);
  }();
  write_atomically(bytes, path);
}

Response parse_hdf5(const std::string &bytes, const std::string &path) {
  const std::lock_guard guard(library_lock());
  const Quiet quiet;
  try {
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "access list");
    check(H5Pset_fapl_core(access, 1 << 20, false), "memory driver");
    // The library only reads from its own copy of the image.
    check(H5Pset_file_image(access, const_cast<char *>(bytes.data()), bytes.size()), "file image");
    const Handle file(H5Fopen("response in memory", H5F_ACC_RDONLY, access), H5Fclose,
                      "damaged or truncated");
    return from_image(file, path);
  } catch (const Error &) {
    throw;
  } catch (const std::exception &error) {
    throw DataError(fmt::format("{}: not a readable HDF5 response: {}", path, error.what()));
  }
}

} // namespace rimpact::scene

// A response as HDF5, from and to bytes.
#include "scene/error.h"
#include "scene/files.h"
#include "scene/hdf5_memory.h"
#include "scene/response_files.h"
#include <fmt/format.h>
#include <hdf5_hl.h>

namespace rimpact::scene {

using namespace hdf5;

namespace {

void write_signal(hid_t group, const SignalInfo &info, const std::vector<double> &values) {
  write_numbers(group, info.name, values);
  const Handle set(H5Dopen2(group, info.name.c_str(), H5P_DEFAULT), H5Dclose, "dataset");
  write_string(set, "units", info.units, true);
  write_string(set, "description", info.description, true);
  if (info.name == "time") {
    check(H5DSset_scale(set, "time"), "dimension scale");
    return;
  }
  const Handle time(H5Dopen2(group, "time", H5P_DEFAULT), H5Dclose, "time");
  check(H5DSattach_scale(set, time, 0), "dimension scale");
}

void write_groups(hid_t file, const Response &response) {
  const Handle group(H5Gcreate2(file, "response", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, "group");
  for (const auto &info : known_signals())
    if (response.has(info.name)) write_signal(group, info, response.series(info.name));
  write_meta(file, response.meta);
}

bool exists(hid_t place, const char *name) {
  return H5Lexists(place, name, H5P_DEFAULT) > 0;
}

/// A file received from others must not make the program read further ones: no links, no external or virtual storage.
void refuse_other_files(hid_t group, const std::string &name) {
  H5L_info_t link;
  check(H5Lget_info(group, name.c_str(), &link, H5P_DEFAULT), "cannot be found");
  if (link.type != H5L_TYPE_HARD) throw std::runtime_error("is a link, values are needed");
  const Handle set(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, "cannot be opened");
  const Handle made(H5Dget_create_plist(set), H5Pclose, "has no properties");
  if (H5Pget_external_count(made) > 0 || H5Pget_layout(made) == H5D_VIRTUAL) throw std::runtime_error("keeps its values in another file");
}

std::vector<double> read_signal(hid_t group, const std::string &name) {
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
  write_atomically(file_in_memory([&](hid_t file) { write_groups(file, response); }), path);
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

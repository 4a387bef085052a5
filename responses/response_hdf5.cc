// A response as HDF5, from and to bytes.
#include "responses/response_hdf5.h"

#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/hdf5_memory.h"
#include <fmt/format.h>
#include <hdf5_hl.h>

namespace rimpact {

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

Response from_image(hid_t file, const std::string &path) {
  if (!exists(file, "response")) throw DataError(fmt::format("{}: holds no group /response", path));
  Response response;
  const Handle group(H5Gopen2(file, "response", H5P_DEFAULT), H5Gclose, "cannot open /response");
  for (const auto &info : known_signals()) {
    if (!exists(group, info.name.c_str())) continue;
    try {
      response.series(info.name) = read_numbers(group, info.name);
    } catch (const std::runtime_error &error) {
      throw DataError(fmt::format("{}: /response/{} {}", path, info.name, error.what()));
    }
  }
  response.meta = read_meta(file);
  return response;
}

} // namespace

void write_hdf5(const Response &response, const std::string &path) {
  response.check();
  if (!response.has("time")) throw std::logic_error("a response without time");
  write_atomically(file_in_memory([&](hid_t file) { write_groups(file, response); }), path);
}

Response parse_hdf5(const std::string &bytes, const std::string &path) {
  Response response;
  try {
    with_image(bytes, [&](hid_t file) { response = from_image(file, path); });
  } catch (const Error &) {
    throw;
  } catch (const std::exception &error) {
    throw DataError(fmt::format("{}: not a readable HDF5 response: {}", path, error.what()));
  }
  return response;
}

} // namespace rimpact

#include "responses/response.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/text.h"
#include "responses/response_csv.h"
#include "responses/response_hdf5.h"
#include "responses/signals.h"
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact {
void Response::append(const std::string &name, double value) {
  series(name).push_back(value);
}

std::vector<double> &Response::series(const std::string &name) {
  const auto found = series_.find(name);
  if (found != series_.end()) return found->second;
  if (!is_signal(name)) throw std::logic_error("signal \"" + name + "\" is not in known_signals()");
  return series_[name];
}

const std::vector<double> &Response::series(const std::string &name) const {
  const auto found = series_.find(name);
  if (found == series_.end()) throw DataError("the response holds no signal \"" + name + "\"");
  return found->second;
}

std::size_t Response::size() const {
  const auto found = series_.find("time");
  return found == series_.end() ? 0 : found->second.size();
}

void Response::check() const {
  for (const auto &[name, values] : series_) {
    if (values.size() != size())
      throw std::logic_error(fmt::format("signal {} has {} values, time has {}", name, values.size(), size()));
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!std::isfinite(values[i])) throw std::logic_error(fmt::format("signal {}, value {}: {}", name, i, values[i]));
  }
}

namespace {

/// What a file must satisfy, whoever wrote it.
void check_read(const Response &response, const std::string &path) {
  if (!response.has("time") || response.size() == 0) throw DataError(fmt::format("{}: holds no instants", path));
  for (const char *name : {"displacement_x", "displacement_y", "force_x", "force_y"})
    if (!response.has(name)) throw DataError(fmt::format("{}: the signal \"{}\" is missing", path, name));
  try {
    response.check();
  } catch (const std::logic_error &error) {
    throw DataError(fmt::format("{}: {}", path, error.what()));
  }
  const auto &time = response.series("time");
  for (std::size_t i = 1; i < time.size(); ++i)
    if (time[i] < time[i - 1])
      throw DataError(fmt::format("{}: time falls from {} s to {} s at instant {}", path, time[i - 1], time[i], i));
}

} // namespace

Response read_response(const std::string &where) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  std::string path = where;
  if (fs::is_directory(where, ignored)) {
    path = (fs::path(where) / "response.h5").string();
    if (!fs::exists(path, ignored)) path = (fs::path(where) / "response.csv").string();
    if (!fs::exists(path, ignored)) throw DataError(fmt::format("{}: holds no response.h5 and no response.csv", where));
  }
  const std::string bytes = read_file(path);
  // HDF5 is known by its signature, whatever the file is called.
  const bool hdf5 = bytes.compare(0, 8, "\x89HDF\r\n\x1a\n") == 0;
  const std::string extension = upper(fs::path(path).extension().string());
  if (!hdf5 && (extension == ".H5" || extension == ".HDF5"))
    throw DataError(fmt::format("{}: is not an HDF5 file (damaged or truncated)", path));
  Response response = hdf5 ? parse_hdf5(bytes, path) : parse_csv(bytes, path);
  check_read(response, path);
  return response;
}

} // namespace rimpact

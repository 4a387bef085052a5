#include "fe_contact/drive/checkpoint.h"

#include "io/files/digest.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/hdf5_memory.h"
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::fe {

using namespace hdf5;

namespace {

constexpr std::size_t header_size = 512; // HDF5 looks for its beginning at 0, 512, 1024 ...
constexpr const char *mark = "rimpact checkpoint, format 10\nsha256 ";

std::string header_of(const std::string &body) {
  std::string header = mark + sha256(body) + "\n";
  header.resize(header_size, '\0');
  return header;
}

herr_t collect(hid_t, const char *name, const H5L_info_t *, void *names) {
  static_cast<std::vector<std::string> *>(names)->push_back(name);
  return 0;
}

std::vector<std::string> names_in(hid_t group) {
  std::vector<std::string> names;
  check(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names), "names");
  return names;
}

/// Values of any type that HDF5 can turn into `type`.
template <class Container> void read_set(hid_t group, const std::string &name, hid_t type, Container &values) {
  const Handle set(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, "data set");
  const Handle space(H5Dget_space(set), H5Sclose, "extent");
  const hssize_t n = H5Sget_simple_extent_npoints(space);
  if (n < 0 || n > 500'000'000) throw std::runtime_error("impossible length");
  values.resize(static_cast<std::size_t>(n));
  if (n > 0) check(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "values");
}

void write_text_set(hid_t group, const std::string &name, const std::string &text) {
  const hsize_t n = text.size();
  const Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose, "space");
  const Handle set(H5Dcreate2(group, name.c_str(), H5T_NATIVE_CHAR, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                   H5Dclose, "text");
  if (n > 0) check(H5Dwrite(set, H5T_NATIVE_CHAR, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), "text");
}

void write_groups(hid_t file, const Checkpoint &checkpoint) {
  const Handle numbers(H5Gcreate2(file, "numbers", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, "group");
  for (const auto &[name, values] : checkpoint.numbers) write_numbers(numbers, name, values);
  const Handle texts(H5Gcreate2(file, "texts", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, "group");
  for (const auto &[name, text] : checkpoint.texts) write_text_set(texts, name, text);
}

void read_groups(const std::string &body, Checkpoint &checkpoint) {
  const std::lock_guard guard(library_lock());
  const Quiet quiet;
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "access list");
  hdf5::check(H5Pset_fapl_core(access, 1 << 20, false), "memory driver");
  hdf5::check(H5Pset_file_image(access, const_cast<char *>(body.data()), body.size()), "file image"); // copied
  const Handle file(H5Fopen("checkpoint in memory", H5F_ACC_RDONLY, access), H5Fclose, "file");
  const Handle numbers(H5Gopen2(file, "numbers", H5P_DEFAULT), H5Gclose, "group numbers");
  for (const auto &name : names_in(numbers)) read_set(numbers, name, H5T_NATIVE_DOUBLE, checkpoint.numbers[name]);
  const Handle texts(H5Gopen2(file, "texts", H5P_DEFAULT), H5Gclose, "group texts");
  for (const auto &name : names_in(texts)) read_set(texts, name, H5T_NATIVE_CHAR, checkpoint.texts[name]);
}

} // namespace

bool Limits::contains(double value) const {
  if (infinite && std::isinf(value)) return true;
  return value >= low && value <= high && (!whole || value == std::floor(value));
}

void Checkpoint::damaged(const std::string &what) const {
  throw DataError(fmt::format("{} is damaged ({}); run without --resume to start afresh",
                              path.empty() ? "the checkpoint" : path, what));
}

const std::vector<double> &Checkpoint::field(const std::string &name, Limits limits) const {
  const auto found = numbers.find(name);
  if (found == numbers.end()) damaged("field " + name + " is missing");
  for (const double value : found->second)
    if (!limits.contains(value)) damaged(fmt::format("field {} holds {:g}, which it cannot", name, value));
  return found->second;
}

const std::vector<double> &Checkpoint::field(const std::string &name, std::size_t due, Limits limits) const {
  const auto &values = field(name, limits);
  if (values.size() != due) damaged(fmt::format("field {} has {} values, {} are due", name, values.size(), due));
  return values;
}

double Checkpoint::number(const std::string &name, Limits limits) const {
  return field(name, 1, limits).front();
}

const std::string &Checkpoint::text(const std::string &name) const {
  const auto found = texts.find(name);
  if (found == texts.end()) damaged("field " + name + " is missing");
  return found->second;
}

void write_checkpoint(const Checkpoint &checkpoint, const std::string &path) {
  const std::string body = file_in_memory([&](hid_t file) { write_groups(file, checkpoint); });
  write_atomically(header_of(body) + body, path);
}

Checkpoint read_checkpoint(const std::string &path) {
  if (!std::filesystem::exists(path))
    throw DataError(
        fmt::format("nothing to resume: {} does not exist, no checkpoint was written yet; run without --resume", path));
  const std::string bytes = read_file(path);
  Checkpoint checkpoint{.numbers = {}, .texts = {}, .path = path};
  if (bytes.starts_with("\x89HDF"))
    throw DataError(path + " was written by an older version of the program; run without --resume to start afresh");
  if (!bytes.starts_with(mark) || bytes.size() <= header_size)
    checkpoint.damaged("it is cut short, or no checkpoint of rimpact");
  const std::string body = bytes.substr(header_size);
  if (bytes.compare(0, header_size, header_of(body)) != 0)
    checkpoint.damaged("its contents do not match their checksum");
  try {
    read_groups(body, checkpoint);
  } catch (const std::runtime_error &error) {
    checkpoint.damaged(fmt::format("it cannot be read: {}", error.what()));
  }
  return checkpoint;
}

} // namespace rimpact::fe

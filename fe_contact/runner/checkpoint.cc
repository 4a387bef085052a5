#include "fe_contact/runner/checkpoint.h"

#include "scene/error.h"
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <hdf5.h>

namespace rimpact::fe {
namespace {

/// Closes an HDF5 handle at the end of its scope.
class Handle {
public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle &) = delete;
  operator hid_t() const { return id_; }
  bool valid() const { return id_ >= 0; }

private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

bool write_array(hid_t file, const std::string &name, hid_t type, const void *data, hsize_t size) {
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  const Handle set(H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                   H5Dclose);
  return set.valid() && H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) >= 0;
}

herr_t collect(hid_t, const char *name, const H5L_info_t *, void *names) {
  static_cast<std::vector<std::string> *>(names)->push_back(name);
  return 0;
}

template <typename Container>
bool read_array(hid_t group, const std::string &name, hid_t type, Container &values) {
  const Handle set(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!set.valid()) return false;
  const Handle space(H5Dget_space(set), H5Sclose);
  values.resize(H5Sget_simple_extent_npoints(space));
  return values.empty() || H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0;
}

} // namespace

double Checkpoint::number(const std::string &name) const {
  const auto found = numbers.find(name);
  if (found == numbers.end() || found->second.empty())
    throw DataError("checkpoint: '" + name + "' is missing");
  return found->second.front();
}

void write_checkpoint(const Checkpoint &checkpoint, const std::string &path) {
  const std::string temporary = path + ".part";
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  bool good = true;
  {
    const Handle file(H5Fcreate(temporary.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
    good = file.valid();
    const Handle numbers(good ? H5Gcreate2(file, "numbers", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT) : -1,
                         H5Gclose);
    const Handle texts(good ? H5Gcreate2(file, "texts", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT) : -1,
                       H5Gclose);
    for (const auto &[name, values] : checkpoint.numbers)
      good = good && write_array(numbers, name, H5T_NATIVE_DOUBLE, values.data(), values.size());
    for (const auto &[name, text] : checkpoint.texts)
      good = good && write_array(texts, name, H5T_NATIVE_CHAR, text.data(), text.size());
    good = good && H5Fflush(file, H5F_SCOPE_GLOBAL) >= 0;
  }
  std::error_code error;
  if (good) std::filesystem::rename(temporary, path, error);
  if (!good || error) {
    std::filesystem::remove(temporary, error);
    throw IoError("cannot write checkpoint " + path + " (disk full or no permission?)");
  }
}

Checkpoint read_checkpoint(const std::string &path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file.valid()) throw DataError(path + ": not a readable checkpoint");
  Checkpoint checkpoint;
  for (const char *kind : {"numbers", "texts"}) {
    const Handle group(H5Gopen2(file, kind, H5P_DEFAULT), H5Gclose);
    std::vector<std::string> names;
    if (!group.valid() || H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names) < 0)
      throw DataError(path + ": not a checkpoint of rimpact");
    for (const auto &name : names)
      if (kind[0] == 'n' ? !read_array(group, name, H5T_NATIVE_DOUBLE, checkpoint.numbers[name])
                         : !read_array(group, name, H5T_NATIVE_CHAR, checkpoint.texts[name]))
        throw DataError(fmt::format("{}: damaged at '{}'", path, name));
  }
  return checkpoint;
}

} // namespace rimpact::fe

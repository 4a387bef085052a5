/// HDF5 through its C interface, in memory: the library never sees a full disk (after a failed write it
/// cannot close its file), and the bytes go through the same atomic write as every other file.
#pragma once
#include <functional>
#include <hdf5.h>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

namespace rimpact::hdf5 {

/// Debian's library is not thread safe; fleets of runs write from several threads.
std::mutex &library_lock();

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
/// Throws std::runtime_error saying `what` failed.
void check(herr_t status, const char *what);

/// Switches the library's own printing off; failures come back as codes.
class Quiet {
public:
  Quiet();
  ~Quiet();

private:
  H5E_auto2_t function_ = nullptr;
  void *data_ = nullptr;
};

/// Text of variable length, which every reader hands back as text.
void write_string(hid_t place, const std::string &name, const std::string &text, bool as_attribute);
void write_numbers(hid_t place, const std::string &name, const std::vector<double> &values);
/// Group /meta with one text each.
void write_meta(hid_t file, const std::map<std::string, std::string> &meta);

bool exists(hid_t place, const char *name);
/// A one-dimensional dataset of numbers that keeps its values in this file. Throws std::runtime_error saying what is
/// wrong with it.
std::vector<double> read_numbers(hid_t group, const std::string &name);
/// The texts of /meta; none where there is no such group.
std::map<std::string, std::string> read_meta(hid_t file);
/// Reads from a file's bytes; takes the library's lock. Throws std::runtime_error for bytes that are no such file, and
/// what `read` throws.
void with_image(const std::string &bytes, const std::function<void(hid_t file)> &read);

/// The bytes of a file that `write` has filled; takes the library's lock.
std::string file_in_memory(const std::function<void(hid_t file)> &write);

} // namespace rimpact::hdf5

#include "io/files/file.h"
#include "io/files/error.h"
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

namespace rimpact {
namespace {

namespace fs = std::filesystem;

/// The temporary file of an atomic write: removed unless it was renamed.
class Temporary {
public:
  explicit Temporary(const std::string &target) : target_(target) {
    std::error_code none;
    const auto kind = fs::status(target, none).type();
    if (kind != fs::file_type::regular && kind != fs::file_type::not_found && kind != fs::file_type::none)
      throw IoError(
          fmt::format("cannot write {}: it is there, and no file", target)); // renaming would replace a device
    const fs::path folder = fs::path(target).parent_path();
    name_ = (folder / fmt::format(".{}.{}.tmp", fs::path(target).filename().string(), ::getpid())).string();
    descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor_ < 0) fail();
  }
  ~Temporary() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!renamed_) ::unlink(name_.c_str());
  }
  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) fail();
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }
  void commit() {
    if (::fsync(descriptor_) != 0 && errno != EINVAL) fail();
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0 || ::rename(name_.c_str(), target_.c_str()) != 0) fail();
    renamed_ = true;
  }

private:
  [[noreturn]] void fail() {
    const std::string reason = std::strerror(errno);
    if (descriptor_ >= 0) ::close(descriptor_);
    ::unlink(name_.c_str()); // the destructor does not run when the constructor throws
    descriptor_ = -1;
    throw IoError(fmt::format("cannot write {}: {}", target_, reason));
  }
  std::string target_, name_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

} // namespace

std::string read_file(const std::string &path) {
  constexpr std::size_t most = 1'000'000'000, piece = 1 << 20;
  const auto fail = [&](const std::string &why) { throw DataError(fmt::format("{}: {}", path, why)); };
  std::error_code error;
  const auto kind = fs::status(path, error).type();
  if (kind == fs::file_type::not_found) fail("no such file");
  if (kind == fs::file_type::directory) fail("is a folder, a file is needed");
  if (kind != fs::file_type::regular) fail("is a pipe or a device, a file is needed"); // it might never end
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) fail(fmt::format("cannot be read: {}", std::strerror(errno)));
  std::string text;
  ssize_t got = 0;
  do {
    const std::size_t before = text.size();
    text.resize(before + piece);
    do got = ::read(descriptor, text.data() + before, piece);
    while (got < 0 && errno == EINTR);
    text.resize(before + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  } while (got > 0 && text.size() <= most);
  const std::string why = got < 0 ? std::strerror(errno) : "";
  ::close(descriptor);
  if (got < 0) fail("cannot be read: " + why);
  if (text.size() > most) fail("larger than 1 GB");
  return text;
}

std::string read_named_file(const std::string &path) {
  try {
    return read_file(path);
  } catch (const DataError &error) {
    throw InputError(error.what());
  }
}

void write_atomically(std::string_view bytes, const std::string &path) {
  Temporary file(path);
  file.write(bytes);
  file.commit();
}

void make_folder(const std::string &path) {
  std::error_code failed;
  fs::create_directories(path, failed);
  if (failed) throw IoError(fmt::format("cannot create the folder {}: {}", path, failed.message()));
}

} // namespace rimpact

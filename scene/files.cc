#include "scene/files.h"
#include "scene/error.h"
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace rimpact::scene {
namespace {

namespace fs = std::filesystem;

/// The temporary file of an atomic write: removed unless it was renamed.
class Temporary {
public:
  explicit Temporary(const std::string &target) : target_(target) {
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
  std::error_code error;
  if (!fs::exists(path, error)) throw DataError(fmt::format("{}: no such file", path));
  if (fs::is_directory(path, error)) throw DataError(fmt::format("{}: is a folder, a file is needed", path));
  const auto size = fs::file_size(path, error);
  if (!error && size > 1'000'000'000) throw DataError(fmt::format("{}: larger than 1 GB", path));
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  if (!stream || (text << stream.rdbuf(), stream.bad()))
    throw DataError(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
  return text.str();
}

void write_atomically(std::string_view bytes, const std::string &path) {
  Temporary file(path);
  file.write(bytes);
  file.commit();
}

} // namespace rimpact::scene

#include "io/files/folder_lock.h"

#include "io/files/error.h"
#include "io/files/text.h"
#include <cerrno>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <filesystem>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace rimpact {
namespace {

namespace fs = std::filesystem;

std::string file_name(const std::string &part) {
  return part.empty() ? ".rimpact.lock" : ".rimpact-" + part + ".lock";
}

std::string contents(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Who this process is, in words.
std::string holder() {
  std::string command = contents("/proc/self/cmdline");
  for (char &c : command)
    if (static_cast<unsigned char>(c) < 0x20) c = ' '; // arguments are parted by zeros
  char host[256] = "an unknown host";
  ::gethostname(host, sizeof host - 1);
  return fmt::format("process {} on {}, since {:%Y-%m-%d %H:%M:%S}: {}", ::getpid(), host,
                     fmt::localtime(std::time(nullptr)), std::string(trim(command)).substr(0, 300));
}

/// The same file still: another process may have removed it, and a third made it anew, between opening and locking.
bool is_at(int descriptor, const std::string &path) {
  struct stat opened, there;
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &there) == 0 && opened.st_ino == there.st_ino &&
         opened.st_dev == there.st_dev;
}

bool no_locks_here(int error) {
  return error == ENOLCK || error == EOPNOTSUPP || error == ENOSYS || error == EINVAL;
}

} // namespace

FolderLock::FolderLock(const std::string &folder, const std::string &part)
    : path_((fs::path(folder) / file_name(part)).string()) {
  std::error_code failed;
  if (fs::create_directories(folder, failed)) made_ = folder;
  if (failed) throw IoError(fmt::format("cannot create the folder {}: {}", folder, failed.message()));
  for (;;) {
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) throw IoError(fmt::format("cannot write in the folder {}: {}", folder, std::strerror(errno)));
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      const int error = errno;
      ::close(std::exchange(descriptor_, -1));
      if (no_locks_here(error)) return;
      const std::string who = contents(path_);
      throw IoError(fmt::format("{} is in use by {}; wait for its end, or choose another folder with -o", folder,
                                who.empty() ? "another process" : std::string(trim(who))));
    }
    if (is_at(descriptor_, path_)) break;
    ::close(std::exchange(descriptor_, -1));
  }
  const std::string who = holder() + "\n";
  // What it says is for people: where it cannot be written (a full disk), the lock holds all the same.
  if (::ftruncate(descriptor_, 0) == 0 && ::write(descriptor_, who.data(), who.size()) < 0) errno = 0;
}

FolderLock::FolderLock(FolderLock &&other) noexcept
    : path_(std::move(other.path_)), made_(std::move(other.made_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

FolderLock::~FolderLock() {
  if (descriptor_ < 0) return;
  ::unlink(path_.c_str()); // while it is held: who opened it before finds that it is not there any more
  ::close(descriptor_);
  if (!made_.empty()) ::rmdir(made_.c_str()); // fails where anything was written
}

} // namespace rimpact

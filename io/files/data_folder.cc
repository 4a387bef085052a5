#include "io/files/data_folder.h"

#include "io/files/error.h"
#include <climits>
#include <filesystem>
#include <unistd.h>

namespace rimpact {

std::string program_folder() {
  char path[PATH_MAX] = {};
  if (readlink("/proc/self/exe", path, sizeof path - 1) < 0)
    throw IoError("cannot find this program's folder (is /proc mounted?)");
  return std::filesystem::path(path).parent_path().string();
}

std::string data_folder() {
  return (std::filesystem::path(program_folder()).parent_path() / "share" / "rimpact").string();
}

} // namespace rimpact

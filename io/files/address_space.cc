#include "io/files/address_space.h"

#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

namespace rimpact {

std::optional<double> address_space_limit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return {};
  return static_cast<double>(limit.rlim_cur);
}

std::optional<double> address_space_left() {
  const auto limit = address_space_limit();
  if (!limit) return {};
  double pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return *limit - pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

} // namespace rimpact

#include "fe_contact/drive/memory_limit.h"

#include "files/error.h"
#include <fmt/format.h>
#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

namespace rimpact::fe {

void need_memory(double bytes) {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return;
  double pages = 0; // of this process's address space, its libraries' most of all
  std::ifstream("/proc/self/statm") >> pages;
  const double left = static_cast<double>(limit.rlim_cur) - pages * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (left < bytes)
    throw SolverStopped(fmt::format("the limit of memory (ulimit -v, {:.2g} GB) leaves {:.2g} GB and the plan asks for "
                                    "{:.2g} GB; a coarser mesh (a lower model.mesh) needs less",
                                    1e-9 * static_cast<double>(limit.rlim_cur), 1e-9 * left, 1e-9 * bytes));
}

} // namespace rimpact::fe

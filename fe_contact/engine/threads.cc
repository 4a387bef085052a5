#include "fe_contact/engine/threads.h"

#include "fe_contact/solver/ranks.h"
#include <algorithm>
#include <cstdlib>

namespace rimpact::fe {

int assembly_threads() {
  static const int n = [] {
    const char *wanted = std::getenv("RIMPACT_THREADS");
    const int cores = std::max(1u, std::thread::hardware_concurrency()) / ranks().size;
    constexpr int most = 256; // more only cost memory, or cannot be had
    return wanted && std::atoi(wanted) > 0 ? std::min(std::atoi(wanted), most) : std::clamp(cores, 1, 8);
  }();
  return n;
}

} // namespace rimpact::fe

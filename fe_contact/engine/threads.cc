#include "fe_contact/engine/threads.h"

#include "fe_contact/solver/ranks.h"
#include "io/files/text.h"
#include <algorithm>
#include <cstdlib>

namespace rimpact::fe {

int assembly_threads() {
  static const int n = [] {
    const char *wanted = std::getenv("RIMPACT_THREADS");
    const double asked = to_number(wanted ? wanted : "").value_or(0);
    const int cores = std::max(1u, std::thread::hardware_concurrency()) / ranks().size;
    constexpr double most = 256; // more only cost memory, or cannot be had
    return asked >= 1 ? static_cast<int>(std::min(asked, most)) : std::clamp(cores, 1, 8);
  }();
  return n;
}

} // namespace rimpact::fe

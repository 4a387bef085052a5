#include "app/console/memory.h"

#include "io/files/address_space.h"
#include <algorithm>
#include <fmt/format.h>
#include <fstream>

namespace rimpact::app {

std::optional<double> available_memory() {
  std::optional<double> available;
  std::ifstream file("/proc/meminfo");
  double kilobytes = 0;
  for (std::string word; file >> word;)
    if (word == "MemAvailable:" && file >> kilobytes) available = 1024 * kilobytes;
  if (const auto own = address_space_limit()) available = std::min(available.value_or(*own), *own);
  return available;
}

std::string doubt_of_memory(double expected_bytes) {
  const auto available = available_memory();
  if (!available || expected_bytes <= *available) return {};
  return fmt::format("the run is expected to need {:.1f} GB of memory and there are {:.1f} GB: it may be ended for "
                     "want of it; a coarser mesh (a lower --mesh) needs less",
                     1e-9 * expected_bytes, 1e-9 * *available);
}

} // namespace rimpact::app

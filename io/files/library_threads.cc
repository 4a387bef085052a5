#include "io/files/library_threads.h"

#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <unistd.h>

namespace rimpact {

bool ask_for_one_library_thread() {
  bool was_so = true;
  for (const char *name : {"OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"}) {
    const char *given = std::getenv(name);
    was_so = was_so && given && std::string_view(given) == "1";
    setenv(name, "1", 1);
  }
  return was_so;
}

void begin_with_one_library_thread(char **argv) {
  if (ask_for_one_library_thread()) return;
  std::error_code none;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", none);
  execv(program.c_str(), argv); // comes back where it cannot: then as many threads as the libraries like
}

} // namespace rimpact

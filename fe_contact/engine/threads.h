/// Threads of one process, for work on cells and faces.
#pragma once
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace rimpact::fe {

/// $RIMPACT_THREADS, else the cores divided among the ranks, at most eight.
int assembly_threads();

/// Calls body(worker) once on each of so many threads, this one among them. What a worker throws is thrown here, once
/// all have ended.
template <typename Body> void on_each_thread(int workers, const Body &body) {
  std::vector<std::exception_ptr> thrown(workers);
  const auto guarded = [&](int w) {
    try {
      body(w);
    } catch (...) {
      thrown[w] = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> threads; // joined on every way out
    for (int w = 1; w < workers; ++w) threads.emplace_back(guarded, w);
    guarded(0);
  }
  for (const auto &exception : thrown)
    if (exception) std::rethrow_exception(exception);
}

/// Calls body(begin, end, worker) on equal shares of [0, n), one thread each; shares do not depend on timing, so
/// results are reproducible for a given number of threads.
template <typename Body> void share(std::size_t n, int workers, const Body &body) {
  on_each_thread(workers, [&](int w) { body(n * w / workers, n * (w + 1) / workers, w); });
}

} // namespace rimpact::fe

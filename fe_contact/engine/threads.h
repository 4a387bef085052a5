/// Threads of one process, for work on cells and faces.
#pragma once
#include <cstddef>
#include <thread>
#include <vector>

namespace rimpact::fe {

/// $RIMPACT_THREADS, else the cores divided among the ranks, at most eight.
int assembly_threads();

/// Calls body(worker) once on each of so many threads, this one among them.
template <typename Body> void on_each_thread(int workers, const Body &body) {
  std::vector<std::thread> threads;
  for (int w = 1; w < workers; ++w) threads.emplace_back([&body, w] { body(w); });
  body(0);
  for (auto &thread : threads) thread.join();
}

/// Calls body(begin, end, worker) on equal shares of [0, n), one thread each; shares do not depend on timing, so
/// results are reproducible for a given number of threads.
template <typename Body> void share(std::size_t n, int workers, const Body &body) {
  on_each_thread(workers, [&](int w) { body(n * w / workers, n * (w + 1) / workers, w); });
}

} // namespace rimpact::fe

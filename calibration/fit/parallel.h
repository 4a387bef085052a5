/// The same question asked of many things that know nothing of each other, by as many threads as the machine has.
#pragma once
#include <algorithm>
#include <atomic>
#include <future>
#include <optional>
#include <thread>
#include <vector>

namespace rimpact::calibration {

/// answers[i] = ask(things[i]). What `ask` throws is thrown here.
template <class Thing, class Ask> auto parallel_map(const std::vector<Thing> &things, Ask ask) {
  std::vector<std::optional<decltype(ask(things.front()))>> found(things.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < things.size(); i = next++) found[i] = ask(things[i]);
  };
  const std::size_t n = std::min<std::size_t>(things.size(), std::max(1u, std::thread::hardware_concurrency()));
  std::vector<std::future<void>> workers;
  for (std::size_t i = 0; i < n; ++i) workers.push_back(std::async(std::launch::async, work));
  for (auto &worker : workers) worker.wait();
  for (auto &worker : workers) worker.get();
  std::vector<decltype(ask(things.front()))> answers;
  answers.reserve(found.size());
  for (auto &each : found) answers.push_back(std::move(*each));
  return answers;
}

} // namespace rimpact::calibration

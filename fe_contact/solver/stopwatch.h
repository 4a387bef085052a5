/// Adds the time of its life to one entry of a run's time split [s].
#pragma once
#include <chrono>

namespace rimpact::fe {

class Stopwatch {
public:
  explicit Stopwatch(double &seconds) : seconds_(seconds), start_(std::chrono::steady_clock::now()) {}
  ~Stopwatch() { seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
  double &seconds_;
  std::chrono::steady_clock::time_point start_;
};

} // namespace rimpact::fe

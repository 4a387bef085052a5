/// The progress line: rewritten in place on a terminal, a plain line every two seconds otherwise.
#pragma once
#include <chrono>
#include <string>

namespace rimpact::app {

class ProgressLine {
public:
  explicit ProgressLine(bool quiet) : quiet_(quiet) {}
  ~ProgressLine() { finish(); }
  void show(const std::string &line);
  void finish(); ///< leaves the last line standing

private:
  bool quiet_, open_ = false;
  std::chrono::steady_clock::time_point last_{};
};

/// "12 s", "3 min 20 s", "1 h 5 min".
std::string duration(double seconds);

} // namespace rimpact::app

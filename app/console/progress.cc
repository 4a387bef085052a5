#include "app/console/progress.h"

#include "app/console/console.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact::app {

void ProgressLine::show(const std::string &line) {
  if (quiet_) return;
  const auto now = std::chrono::steady_clock::now();
  const auto pause = std::chrono::milliseconds(is_terminal() ? 100 : 10000);
  if (now - last_ < pause) return;
  last_ = now;
  if (!is_terminal()) {
    say(line + "\n");
    return;
  }
  say("\r\033[K" + line);
  std::fflush(stderr);
  open_ = true;
}

void ProgressLine::finish() {
  if (open_) say("\n");
  open_ = false;
}

std::string duration(double seconds) {
  const long s = std::lround(seconds);
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{} min {} s", s / 60, s % 60);
  return fmt::format("{} h {} min", s / 3600, s % 3600 / 60);
}

} // namespace rimpact::app

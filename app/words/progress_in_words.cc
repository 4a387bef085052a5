#include "app/words/progress_in_words.h"

#include <fmt/format.h>

namespace rimpact::app {

std::string ProgressInWords::of(const fe::Progress &p) {
  if (p.gap != last_gap_) springing_back_ = p.gap > last_gap_;
  last_gap_ = p.gap;
  const std::string when = window_    ? ""
                           : in_time_ ? fmt::format(", {:.2f} of {:.4g} s", p.time, p.end_time)
                                      : fmt::format(", {:.0f} % of the path", 100 * p.time / p.end_time);
  if (p.phase == fe::Phase::contact || p.phase == fe::Phase::pressing) {
    const char *doing = springing_back_ ? "springing back" : "pressing";
    const std::string depth = p.gap < 0 ? fmt::format("{:.1f} mm into the rim", -1e3 * p.gap) : "at the rim";
    return fmt::format("{}, {}, {:.0f} kN{}", doing, depth, 1e-3 * p.force, when);
  }
  const std::string doing = word(p.phase == fe::Phase::flight ? fe::Phase::sliding : p.phase);
  return fmt::format("{}, {:.1f} mm from the rim{}", doing, 1e3 * p.gap, when);
}

std::string numbers_of(const fe::Progress &p) {
  return fmt::format("  t {:.4f}, step {:.3g}, {} Newton iterations", p.time, p.step, p.newton_iterations);
}

} // namespace rimpact::app

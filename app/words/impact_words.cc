#include "app/words/impact_words.h"

#include "responses/open_impact.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact::app {

std::string speed_in_words(double speed, int decimals) {
  constexpr double slow = 1e-3;
  const double shown = speed == 0 ? 0 : speed; // never -0
  if (shown != 0 && std::abs(shown) < slow) return fmt::format("{:.3g} mm/s", 1e3 * shown);
  return fmt::format("{:.{}f} m/s", shown, decimals);
}

std::string when(const Impact &impact, bool is_dynamic) {
  return is_dynamic ? fmt::format("{:.4f} s", impact.touch_time)
                    : fmt::format("{:.2f} % of the path", 100 * impact.touch_time);
}

std::string how_fast(const Impact &impact, bool is_dynamic, int decimals) {
  if (!is_dynamic) return is_open(impact) ? "pressed, not let go" : "pressed and let go";
  const double in = impact.approach_speed > 0 ? impact.approach_speed : 0.0;
  return fmt::format("in {}  {}", speed_in_words(in, decimals),
                     is_open(impact) ? "not let go" : "out " + speed_in_words(impact.rebound_speed, decimals));
}

} // namespace rimpact::app

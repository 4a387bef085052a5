#include "responses/open_impact.h"

namespace rimpact {

Impact left_open(Impact impact) {
  impact.release_time = impact.touch_time - 1;
  impact.rebound_speed = 0;
  return impact;
}

bool is_open(const Impact &impact) {
  return impact.release_time < impact.touch_time;
}

bool still_bears(double force, double peak) {
  constexpr double gone = 0.01; // what is left changes the speed by less than a thousandth
  return force > gone * peak;
}

void leave_last_impact_open(const Response &r, Summary &s) {
  if (r.size() == 0 || !r.has("impact_x") || !r.has("impact_y")) return;
  if (r.series("impact_x").back() == 0 && r.series("impact_y").back() == 0) return;
  Summary shown;
  summarise_response(r, shown);
  const Impact &last = shown.impacts.back();
  const bool listed =
      !s.impacts.empty() && (is_open(s.impacts.back()) || s.impacts.back().release_time >= last.touch_time);
  if (!listed) s.impacts.push_back(last);
  s.impacts.back() = left_open(s.impacts.back());
}

} // namespace rimpact

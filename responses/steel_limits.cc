#include "responses/steel_limits.h"

#include <cmath>

namespace rimpact {

scene::SteelPart part_of(SteelPlace place) {
  switch (place) {
  case SteelPlace::rim_wall:
  case SteelPlace::rim_root:
    return scene::SteelPart::rim;
  case SteelPlace::dish:
    return scene::SteelPart::dish;
  case SteelPlace::slider_edge:
    break;
  }
  return scene::SteelPart::slider;
}

std::optional<double> limit_at(const scene::Bearing &bearing, SteelPlace place) {
  return bearing.steel_of(part_of(place)).strain_limit;
}

std::string limit_key(const scene::Bearing &bearing, SteelPlace place) {
  const scene::SteelPart part = part_of(place);
  return "material." + (bearing.part_steels.count(part) ? word(part) : "steel") + ".strain_limit";
}

bool limit_is_assumed(const scene::Bearing &bearing, SteelPlace place) {
  return bearing.assumed.keys.count(limit_key(bearing, place)) > 0;
}

SteelPlace weakest_of_the_rim(const scene::Bearing &bearing) {
  const auto limit = [&](SteelPlace place) { return limit_at(bearing, place).value_or(HUGE_VAL); };
  return limit(SteelPlace::dish) < limit(SteelPlace::rim_wall) ? SteelPlace::dish : SteelPlace::rim_wall;
}

} // namespace rimpact

#include "files/error.h"
#include "files/text.h"
#include "scene/assumptions.h"
#include <array>

namespace rimpact::scene {
namespace {

/// The thesis's SH-FPS: R0 = 2.25 m, a = R0/4.
Bearing shfps_225() {
  return {};
}

/// Its spherical sibling (a = R0): same capacity, slider, foot and pad. The dish's edge lies lower, so the
/// rim is higher for the same overlap with the slider's wall, and the pad is shaped to the dish.
Bearing fps_225() {
  Bearing b;
  b.name = "fps-225";
  b.surface.kind = "sphere";
  b.surface.a = b.surface.R0;
  b.rim.height = 0.080;
  b.pad.shape_radius = b.surface.R0;
  return b;
}

struct Entry {
  const char *name;
  Bearing (*make)();
};
// The catalogue: one line a bearing.
constexpr std::array catalogue{
    Entry{"shfps-225", shfps_225},
    Entry{"fps-225", fps_225},
};

} // namespace

std::vector<std::string> builtin_bearing_names() {
  std::vector<std::string> names;
  names.reserve(catalogue.size());
  for (const auto &entry : catalogue) names.emplace_back(entry.name);
  return names;
}

Bearing builtin_bearing(const std::string &name) {
  for (const auto &entry : catalogue)
    if (name == entry.name) {
      Bearing bearing = entry.make();
      bearing.assumed = catalogue_marks();
      return bearing;
    }
  throw InputError("bearing " + not_among(name, builtin_bearing_names()));
}

} // namespace rimpact::scene

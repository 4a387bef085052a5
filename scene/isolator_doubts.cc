#include "scene/isolator_doubts.h"
#include "scene/spherical_cap.h"
#include "scene/triple_pendulum.h"
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

/// Two dishes that face each other, with what lies between them in the middle.
struct FacingDishes {
  const char *key, *bodies;
  double rim_height; ///< of each [m]
  double between;    ///< the edges of the dishes, where the rims begin [m]
};

FacingDishes facing(const char *key, const char *bodies, const TripleFace &low, const TripleFace &high) {
  return {key, bodies, low.rim_height,
          low.height - cap_height(low.radius, low.rim_radius()) + high.height -
              cap_height(high.radius, high.rim_radius())};
}

std::vector<FacingDishes> facing_dishes(const Isolator &b, ModelKind model) {
  if (model == ModelKind::tfp) {
    const auto f = triple_faces(b);
    return {facing("rim_height_mm", "plates", f[0], f[3]), facing("inner.rim_height_mm", "slide plates", f[1], f[2])};
  }
  return {{"rim_height_mm", "plates", b.rim_height,
           b.slider_height() - cap_height(b.radius, b.bottom_rim_radius()) -
               cap_height(b.upper_radius(), b.top_rim_radius())}};
}

} // namespace

std::vector<std::string> doubts_of_isolator(const Isolator &isolator, ModelKind model) {
  constexpr double drawn = 1e-3; // what a rounded figure may leave [m]
  constexpr double mm = 1e3;
  std::vector<std::string> found;
  for (const auto &[key, bodies, rim_height, between] : facing_dishes(isolator, model)) {
    const double overlap = 2 * rim_height - between;
    if (overlap <= drawn) continue;
    const std::string edges = between > 0
                                  ? fmt::format("for the edges of their dishes are {:.3g} mm apart", mm * between)
                                  : fmt::format("and the edges of their dishes by {:.3g} mm", -mm * between);
    found.push_back(
        fmt::format("isolator.{} = {:g}: at rest the rims of the two {} lie in one another by {:.3g} mm, {}. "
                    "No bearing is built like that: its sliders are higher, its rims lower, or its travel is smaller",
                    key, mm * rim_height, bodies, mm * overlap, edges));
  }
  return found;
}

} // namespace rimpact::scene

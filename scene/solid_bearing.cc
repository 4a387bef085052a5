#include "scene/solid_bearing.h"

#include <fmt/format.h>

namespace rimpact::scene {

std::optional<std::string> without_solid_bearing(const Scene &scene, const std::string &taker) {
  if (!scene.rigid_bodies()) return std::nullopt;
  const char *way = scene.reduced.model == ModelKind::tfp
                        ? "a triple pendulum by the bearings of its stops (tfp-kim-2023-inner)"
                        : "two dishes by surface.concave = \"double\"";
  return fmt::format(
      "reduced.model \"{}\" has its bearing in [isolator], of rigid bodies: {} one that [bearing] gives, "
      "{}; `rimpact reduced` runs this scene",
      word(scene.reduced.model), taker, way);
}

} // namespace rimpact::scene

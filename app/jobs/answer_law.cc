#include "app/jobs/answer_law.h"

#include "io/files/key_list.h"
#include "scene/toml_writer.h"
#include <filesystem>

namespace rimpact::app {

scene::Scene with_answer(const scene::Scene &scene, const std::string &folder) {
  const std::string absolute = std::filesystem::absolute(folder).lexically_normal().string();
  return scene::parse_scene(scene::to_toml(scene), scene.name, {"reduced.calibration=" + toml_quoted(absolute)});
}

scene::Scene with_pair(scene::Scene scene, const calibration::PairRange &pair) {
  const auto value_of = [&](const char *name) { return pair.result.parameters.at(name).value; };
  scene.reduced.impact_law = &laws::impact_law(pair.law);
  scene.reduced.k_i = 1e3 * value_of("k_i");
  scene.reduced.restitution = value_of("e");
  return scene;
}

} // namespace rimpact::app

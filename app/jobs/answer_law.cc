#include "app/jobs/answer_law.h"

#include "io/files/key_list.h"
#include "scene/toml_writer.h"
#include <filesystem>

namespace rimpact::app {

scene::Scene with_answer(const scene::Scene &scene, const std::string &folder) {
  const std::string absolute = std::filesystem::absolute(folder).lexically_normal().string();
  return scene::parse_scene(scene::to_toml(scene), scene.name, {"reduced.calibration=" + toml_quoted(absolute)});
}

scene::Scene with_pair(scene::Scene scene, const nlohmann::json &answer) {
  const auto &pair = answer.at("pair");
  scene.reduced.impact_law = &laws::impact_law(pair.at("law"));
  scene.reduced.k_i = 1e3 * pair.at("k_i_kN_per_m").get<double>();
  scene.reduced.restitution = pair.at("e");
  return scene;
}

} // namespace rimpact::app

/// What a calibration answers, put into a scene.
#pragma once
#include "scene/scene.h"
#include <nlohmann/json.hpp>

namespace rimpact::app {

/// The scene with the law, numbers and range of the calibration in FOLDER, as --calibration FOLDER makes it.
scene::Scene with_answer(const scene::Scene &scene, const std::string &folder);

/// The scene with the constant pair of `answer` (calibration.json); `answer["pair"]` must not be null.
scene::Scene with_pair(scene::Scene scene, const nlohmann::json &answer);

} // namespace rimpact::app

/// What a calibration answers, as `main` uses it: the law and the pair put into a scene, and what is said of them.
#pragma once
#include "scene/scene.h"
#include <nlohmann/json.hpp>

namespace rimpact::app {

/// The scene with every key of [reduced] in FOLDER/calibration.toml: the answer's law and its numbers. Throws InputError.
scene::Scene with_answer(const scene::Scene &scene, const std::string &folder);

/// The scene with the constant pair of `answer` (calibration.json); `answer["pair"]` must not be null.
scene::Scene with_pair(scene::Scene scene, const nlohmann::json &answer);

/// Law with its numbers, range and error, pair or why there is none, strain, doubts: sentences of the record itself.
std::string answer_text(const nlohmann::json &answer);

} // namespace rimpact::app

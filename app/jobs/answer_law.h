/// What a calibration answers, put into a scene.
#pragma once
#include "calibration/laws/pair_range.h"
#include "scene/scene.h"

namespace rimpact::app {

/// The scene with the law, numbers and range of the calibration in FOLDER, as --calibration FOLDER makes it.
scene::Scene with_answer(const scene::Scene &scene, const std::string &folder);

/// The scene with a constant pair.
scene::Scene with_pair(scene::Scene scene, const calibration::PairRange &pair);

} // namespace rimpact::app

/// An answer as JSON (docs/interface.md, calibration.json): what the program reads again (scene/stored_answer.h), and
/// what the report alone reads.
#pragma once
#include "calibration/answer/answer.h"
#include "scene/stored_answer.h"

namespace rimpact::calibration {

scene::StoredAnswer stored(const Answer &answer);
/// As it is stored, with the table over speed and what stands behind strain, foot, band and errors.
nlohmann::json to_json(const Answer &answer);

} // namespace rimpact::calibration

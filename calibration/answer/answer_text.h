/// An answer as text.
#pragma once
#include "calibration/answer/answer.h"

namespace rimpact::calibration {

/// [reduced] of a scene file: law, numbers, range, rim. Comments first.
std::string to_toml_fragment(const Answer &answer);
/// For the terminal.
std::string describe(const Answer &answer);

} // namespace rimpact::calibration

/// What may be wrong with a steel that has a name.
#pragma once
#include "scene/bearing.h"
#include <string>
#include <vector>

namespace rimpact::scene {

/// A sentence where the file's own numbers stand in the grade's place, and one where the rim is thicker than the
/// grade's tables go. None without a grade.
std::vector<std::string> doubts_of_grade(const Bearing &bearing);

} // namespace rimpact::scene

/// What the runs say of the steel: strain and damage by place, and the speeds at which limits are passed.
#pragma once
#include "calibration/answer/answer.h"

namespace rimpact::calibration {

/// Its sentence begins with the joint at the rim's foot, where that goes in a run.
std::optional<AnswerStrain> answer_strain(const Calibration &calibration, const std::vector<const StoredRun *> &runs,
                                          const std::optional<AnswerFoot> &foot);

} // namespace rimpact::calibration

/// The seven parts of every number's error.
#pragma once
#include "calibration/answer/answer.h"
#include "calibration/studies/stored_study.h"

namespace rimpact::calibration {

/// To be called last: it reads the answer's law, rungs and error of the mesh.
std::vector<AnswerError> answer_errors(const Calibration &calibration, const Answer &answer,
                                       const std::vector<const StoredRun *> &runs,
                                       const std::vector<StoredStudy> &studies);

} // namespace rimpact::calibration

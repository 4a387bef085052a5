/// The error of the mesh, as kept studies tell it of the fitted runs.
#pragma once
#include "calibration/answer/answer.h"
#include "calibration/studies/stored_study.h"

namespace rimpact::calibration {

AnswerMeshError answer_mesh_error(const Calibration &calibration, const std::vector<const StoredRun *> &runs,
                                  const std::vector<StoredStudy> &studies);

} // namespace rimpact::calibration

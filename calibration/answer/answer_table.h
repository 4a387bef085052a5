/// The answer's rows by speed, and the constant pair that stands for its law.
#pragma once
#include "calibration/answer/answer.h"

namespace rimpact::calibration {

/// Five rows (one where all runs are of one speed).
std::vector<AnswerRow> answer_table(const scene::Scene &scene, const AnswerLaw &law);
/// Fills pair or no_pair.
void answer_pair(const Calibration &calibration, Answer &answer);

} // namespace rimpact::calibration

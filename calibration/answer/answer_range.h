/// The law of an answer: over which speeds it holds, and how well.
#pragma once
#include "calibration/answer/answer.h"
#include "calibration/answer/answer_choice.h"

namespace rimpact::calibration {

/// Range, errors and sentence of the law; `scene` holds its numbers.
AnswerLaw answer_law(const Choice &choice, const scene::Scene &scene, const std::vector<const StoredRun *> &runs,
                     double tolerance);
std::string validity_sentence(const Answer &answer);

} // namespace rimpact::calibration

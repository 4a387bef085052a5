/// The parts of an answer, one function each. See answer.h.
#pragma once
#include "calibration/answer/answer.h"
#include "calibration/studies/stored_study.h"

namespace rimpact::calibration {

/// A law's row of the ranking (or of the one fit there is) as the answer.
struct Choice {
  LawRow row;
  ChosenBy chosen_by; ///< this and the remark as in AnswerLaw
  std::string remark;
};
/// Of rows that leave less and less, the one that leaves least among those met at two neighbouring runs left out or
/// more; where none is, the one that leaves least. nullptr: no row.
const LawRow *best_valid(const LawRanking &ranking);
Choice choose(const Calibration &calibration, const CalibrationOptions &options,
              const std::vector<const StoredRun *> &fitted);

/// Range, errors and sentence of the law; `scene` holds its numbers.
AnswerLaw answer_law(const Choice &choice, const scene::Scene &scene, const std::vector<const StoredRun *> &runs,
                     double tolerance);
std::string validity_sentence(const Answer &answer);

/// Five rows (one where all runs are of one speed).
std::vector<AnswerRow> answer_table(const scene::Scene &scene, const AnswerLaw &law);
/// Fills pair or no_pair.
void answer_pair(const Calibration &calibration, Answer &answer);
std::optional<AnswerStrain> answer_strain(const Calibration &calibration, const std::vector<const StoredRun *> &runs);
/// To be called last: it reads the answer's law, rungs and error of the mesh.
std::vector<AnswerError> answer_errors(const Calibration &calibration, const Answer &answer,
                                       const std::vector<const StoredRun *> &runs,
                                       const std::vector<StoredStudy> &studies);
AnswerMeshError answer_mesh_error(const Calibration &calibration, const std::vector<const StoredRun *> &runs,
                                  const std::vector<StoredStudy> &studies);

} // namespace rimpact::calibration

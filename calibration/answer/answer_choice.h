/// Which law of a ranking is the answer, and why.
#pragma once
#include "calibration/answer/answer.h"

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

} // namespace rimpact::calibration

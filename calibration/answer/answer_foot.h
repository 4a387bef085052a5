/// Whether the rim's foot bears the impacts of the runs, and what a joint there would have to bear.
#pragma once
#include "calibration/answer/calibration.h"
#include "calibration/answer/passing.h"
#include "calibration/answer/steel_band.h"
#include "responses/foot_report.h"

namespace rimpact::calibration {

struct AnswerLaw;

/// The foot in runs of one steel.
struct FootOfRuns {
  struct Row {
    double speed; ///< approach [m/s]
    FootReport foot;
  };
  std::vector<Row> rows = {}; ///< by speed
  Passing gone = {};          ///< where the joint's use passes 1; nothing of a rim in one piece with its plate
  const Row &hardest() const; ///< of one row at least
};

struct AnswerFoot {
  scene::RimConnection connection;
  FootOfRuns runs, twins; ///< twins: with the other steel; empty: none was run
  bool twins_are_fast = true;
  std::optional<double>
      goes_at_force; ///< of the rim, the least of all runs of either steel [N]; none: the foot bears all
  std::string sentence;
  std::string doubt; ///< of a law whose runs go on where the joint does not; else empty

  std::optional<double> goes_at() const; ///< slowest run beyond, of either steel [m/s]; none: the foot bears all
  /// Fastest run that bears it, and is slower than where the twins go on a straight line between them [m/s]; none: no
  /// run, or all of them.
  std::optional<double> borne_to() const;
  std::string goes_in_words() const; ///< between or below which speeds; empty: the foot bears all
};

/// None: no run tells.
std::optional<AnswerFoot> answer_foot(const Calibration &calibration, const std::vector<const StoredRun *> &runs,
                                      const std::optional<SteelBand> &band);
/// Beyond the fastest run whose foot bears it the solids are no result: there the law ends.
void end_at_foot(const AnswerFoot &foot, AnswerLaw &law);

} // namespace rimpact::calibration

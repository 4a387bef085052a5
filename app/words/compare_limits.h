/// Limits that a comparison has to keep (`compare --max`), and their verdicts as text, JSON and JUnit.
#pragma once
#include "app/words/compared_figures.h"
#include <nlohmann/json.hpp>

namespace rimpact::app {

struct FigureLimit {
  const ComparedFigure *figure;
  double most; ///< of the magnitude, in the figure's unit, >= 0
};
/// Of "peak=5,rebound=10" words, in the figures' order. Throws InputError naming the word, what is known and the bound.
std::vector<FigureLimit> limits_of(const std::vector<std::string> &words);

/// What came of one limit. A figure that is not known keeps no limit, and neither does one of a run that is no result.
struct Verdict {
  FigureLimit limit;
  std::optional<double> value; ///< in the figure's unit
  bool met;
  std::string why = {}; ///< it is not met although no value lies beyond: a sentence
};
/// One candidate's; `doubt`: why its figures, or the reference's, are no result, a sentence; empty: they are.
struct Judged {
  std::string name, path; ///< B, and its folder
  std::vector<Verdict> verdicts;
};
Judged judge(const std::vector<FigureLimit> &limits, const calibration::Comparison &metrics, const std::string &doubt);

/// A row a limit, a column a candidate; empty without limits.
std::string text_of(const std::vector<Judged> &all);
nlohmann::json to_json(const Judged &judged);
/// As continuous integration reads it: a suite for the reference, a case for each candidate and limit.
std::string junit_of(const std::string &reference, const std::vector<Judged> &all);
/// Throws GateError naming what is not met.
void require_met(const std::vector<Judged> &all);

} // namespace rimpact::app

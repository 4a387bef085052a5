// The parts of an answer's errors, each with how it is known. None is silently zero.
#include "calibration/answer/answer_errors.h"

#include "calibration/answer/solid_errors.h"
#include "laws/impact/catalogue.h"
#include <algorithm>
#include <cmath>

namespace rimpact::calibration {
namespace {

using Runs = SolidErrors::Runs;

/// Of the law: runs left out of the fit, and the intervals of its own numbers.
class LawParts {
public:
  LawParts(const Answer &answer, const Runs &runs) : answer_(answer), runs_(runs) {}

  void add_to(ErrorParts &parts) const {
    const auto &worst = answer_.law.worst_left_out;
    const auto part = [&](double WorstErrors::*of, double LawError::*each) {
      if (!worst) return ErrorPart{.value = {}, .from = "no run was left out: more impacts are needed"};
      return ErrorPart{
          .value = (*worst).*of, .how = Known::measured, .from = "runs left out of the fit", .by = by(each)};
    };
    parts.add(Erring::peak_force, ErrorSource::law, part(&WorstErrors::peak_force, &LawError::peak_force));
    parts.add(Erring::depth, ErrorSource::law, part(&WorstErrors::depth, &LawError::depth));
    parts.add(Erring::rebound, ErrorSource::law, part(&WorstErrors::rebound, &LawError::rebound));
    for (const auto &[quantity, name] : {std::pair{Erring::k_i, "k_i"}, {Erring::e, "e"}})
      if (answer_.scene.reduced.impact_law->reads(name)) parts.add(quantity, ErrorSource::law, interval(name));
    if (answer_.strain) parts.add(Erring::strain, ErrorSource::law, no_error("the strain is the runs' own, of no law"));
  }

private:
  /// Where the law holds, else of all.
  std::vector<ErrorAt> by(double LawError::*each) const {
    std::vector<ErrorAt> rows;
    const AnswerLaw &law = answer_.law;
    for (const LawError &error : law.left_out)
      if (std::isfinite(error.*each) &&
          (!law.valid_from || (error.speed >= *law.valid_from && error.speed <= *law.valid_to)))
        rows.push_back(
            {load_of(runs_, error.folder), error.speed, depth_of(runs_, error.folder), std::abs(error.*each)});
    return rows;
  }
  /// Half the 95 % interval of a law's own number.
  ErrorPart interval(const std::string &name) const {
    const auto found = answer_.law.result.parameters.find(name);
    if (found == answer_.law.result.parameters.end()) return {.value = {}, .from = "held, not fitted"};
    const Estimate &e = found->second;
    return {.value = std::max(e.interval_high - e.value, e.value - e.interval_low) / e.value,
            .how = Known::measured,
            .from = "its 95 % interval"};
  }
  const Answer &answer_;
  const Runs &runs_;
};

} // namespace

std::vector<AnswerError> answer_errors(const Calibration &c, const Answer &answer, const Runs &runs,
                                       const std::vector<StoredStudy> &studies) {
  ErrorParts parts;
  if (answer.sources.count(RunSource::finite_elements) > 0) SolidErrors(c, answer, runs, studies).add_to(parts);
  LawParts(answer, runs).add_to(parts);
  const laws::ImpactLaw &law = *answer.scene.reduced.impact_law;
  parts.of_similar(law.reads("k_i"), law.reads("e"), answer.strain.has_value());
  return parts.all();
}

} // namespace rimpact::calibration

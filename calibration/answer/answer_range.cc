#include "calibration/answer/answer_range.h"
#include "calibration/laws/law_words.h"
#include "calibration/laws/percent.h"
#include "scene/case_description.h"
#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {

namespace {

struct Speeds {
  double from, to; ///< [m/s]
  bool hold(double speed) const { return speed >= from && speed <= to; }
};
std::string in_words(const Speeds &s) {
  return s.to > s.from * 1.001 ? fmt::format("from {:.3g} to {:.3g} m/s", s.from, s.to)
                               : fmt::format("at {:.3g} m/s", s.from);
}

/// Largest errors of the runs whose speed passes; none where no run does: the largest of nothing is not zero.
template <class Passes> std::optional<WorstErrors> worst_of(const std::vector<LawError> &errors, Passes passes) {
  std::optional<WorstErrors> worst;
  for (const auto &e : errors)
    if (passes(e.speed)) {
      if (!worst) worst.emplace();
      worst->peak_force = larger_of(worst->peak_force, std::abs(e.peak_force));
      worst->depth = larger_of(worst->depth, std::abs(e.depth));
      worst->rebound = larger_of(worst->rebound, std::abs(e.rebound));
    }
  return worst;
}

std::optional<WorstErrors> larger(const std::optional<WorstErrors> &a, const std::optional<WorstErrors> &b) {
  if (!a || !b) return a ? a : b;
  return WorstErrors{larger_of(a->peak_force, b->peak_force), larger_of(a->depth, b->depth),
                     larger_of(a->rebound, b->rebound), a->inside_valid_range};
}

/// "runs fitted are met within 2 % in peak force and 3 % in rebound", or that it is not known.
std::string met(const std::string &runs, const std::optional<WorstErrors> &worst) {
  if (!worst || std::isnan(worst->peak_force))
    return fmt::format("how near it comes to {} is not known: no hard impact of theirs can be judged", runs);
  const std::string rebound = std::isnan(worst->rebound) ? "an unknown error"
                              : worst->rebound < 1       ? percent_up(worst->rebound)
                                                         : "not at all"; // of one that hardly is, a number says nothing
  return fmt::format("{} are met within {} in peak force and {} in rebound", runs, percent_up(worst->peak_force),
                     rebound);
}

std::string as_sentence(std::string text) {
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text + ".";
}

/// Where the law holds, by the runs left out and those fitted: what is stated holds of both. Sentences.
std::string where(const AnswerLaw &law) {
  const auto all = [](double) { return true; };
  const auto over = [&](const std::string &runs, auto passes) {
    return met(runs, larger(worst_of(law.left_out, passes), worst_of(law.fitted, passes)));
  };
  const std::string both = "runs fitted and runs left out in turn";
  if (law.left_out.empty())
    return fmt::format("No run could be left out to try it, so how it predicts is not known. {}",
                       as_sentence(met("the runs fitted", worst_of(law.fitted, all))));
  if (!law.valid_from)
    return fmt::format("It holds nowhere within {:.0f} %. {}", 100 * law.tolerance, as_sentence(over(both, all)));
  const Speeds valid{*law.valid_from, *law.valid_to};
  std::string text =
      as_sentence(fmt::format("{}, {}", in_words(valid), over(both, [&](double v) { return valid.hold(v); })));
  if (std::any_of(law.left_out.begin(), law.left_out.end(), [&](const auto &e) { return !valid.hold(e.speed); }))
    text += " " + as_sentence("at other speeds, " + over("they", [&](double v) { return !valid.hold(v); }));
  return text;
}

/// "8 runs by finite elements (rung rim, mesh 1)", "2 measured curves".
std::string made_by(const Answer &answer) {
  const int n = answer.law.n_runs;
  const char *plural = n == 1 ? "" : "s";
  if (answer.sources == std::set{RunSource::measured}) return fmt::format("{} measured curve{}", n, plural);
  std::string text = fmt::format("{} run{} by {}", n, plural, answer.source());
  if (answer.sources != std::set{RunSource::finite_elements}) return text;
  const char *before = " (rung ";
  for (const auto &rung : answer.rungs) text += before + rung, before = ", ";
  before = ", mesh ";
  for (const int mesh : answer.meshes) text += before + std::to_string(mesh), before = ", ";
  return text + ")";
}

} // namespace

AnswerLaw answer_law(const Choice &choice, const scene::Scene &scene, const std::vector<const StoredRun *> &runs,
                     double tolerance) {
  const LawRow &row = choice.row;
  AnswerLaw law;
  law.result = row.result, law.chosen_by = choice.chosen_by, law.remark = choice.remark, law.held = row.held;
  law.of_the_mass = belongs_to_mass(scene.reduced);
  law.tolerance = tolerance, law.unexplained = row.unexplained, law.n_runs = static_cast<int>(row.fitted.size());
  law.valid_from = row.valid_from, law.valid_to = row.valid_to;
  law.left_out = left_out_runs(row);
  const bool firm = std::any_of(row.fitted.begin(), row.fitted.end(), [](const auto &e) { return !e.grazing; });
  for (const auto &e : row.fitted)
    if (!e.grazing || !firm) law.fitted.push_back(e);
  std::sort(law.fitted.begin(), law.fitted.end(), [](const auto &a, const auto &b) { return a.speed < b.speed; });
  std::vector<double> speeds;
  for (const bool grazing : {false, true}) // grazing ones only where there is nothing else
    for (const StoredRun *run : runs)
      for (const auto &w : run->impacts)
        if (std::any_of(row.fitted.begin(), row.fitted.end(), [&](const auto &e) { return e.folder == run->folder; }) &&
            w.grazing == grazing && grazing != firm)
          speeds.push_back(w.impact.approach_speed);
  if (!speeds.empty())
    law.fitted_from = *std::min_element(speeds.begin(), speeds.end()),
    law.fitted_to = *std::max_element(speeds.begin(), speeds.end());
  if (!law.left_out.empty()) {
    law.worst_left_out = worst_of(
        law.left_out, [&](double v) { return !law.valid_from || (v >= *law.valid_from && v <= *law.valid_to); });
    if (law.worst_left_out) law.worst_left_out->inside_valid_range = law.valid_from.has_value();
  }
  std::string name = law_in_words(scene);
  name.front() = 'T';
  law.sentence = fmt::format("{} is fitted to {} run{} {}. {}{}", name, law.n_runs, law.n_runs == 1 ? "" : "s",
                             in_words(Speeds{law.fitted_from, law.fitted_to}), where(law),
                             law.of_the_mass ? "" : " It belongs to the rim and serves any supported mass.");
  return law;
}

std::string validity_sentence(const Answer &answer) {
  const auto &law = answer.law;
  return fmt::format("Law {} of bearing {} ({}) serves {}. It is fitted to {} {}. {}", law.result.law,
                     answer.scene.bearing.name, scene::rim_in_words(answer.scene.bearing),
                     law.of_the_mass ? fmt::format("a supported mass of {:.6g} kg only", answer.scene.load.mass)
                                     : "any supported mass",
                     made_by(answer), in_words(Speeds{law.fitted_from, law.fitted_to}), where(law)) +
         (law.end.empty() ? "" : " " + law.end);
}

} // namespace rimpact::calibration

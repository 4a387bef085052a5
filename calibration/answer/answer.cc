#include "calibration/answer/answer.h"
#include "calibration/answer/answer_choice.h"
#include "calibration/answer/answer_errors.h"
#include "calibration/answer/answer_mesh_error.h"
#include "calibration/answer/answer_range.h"
#include "calibration/answer/answer_strain.h"
#include "calibration/answer/answer_table.h"
#include "calibration/laws/percent.h"
#include "calibration/studies/stored_study.h"
#include "scene/doubts.h"
#include "scene/element_doubts.h"
#include "scene/rim_identity.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <set>

namespace rimpact::calibration {

using nlohmann::json;

namespace {
namespace fs = std::filesystem;
using Runs = std::vector<const StoredRun *>;

/// Studies kept with the program, beside the runs and above them, as far as `main` puts its runs below `results`.
std::vector<StoredStudy> studies_near(const std::string &folder) {
  std::vector<StoredStudy> studies;
  std::set<std::string> seen;
  fs::path above = fs::absolute(folder).lexically_normal();
  for (int n = 0; n < 4 && above.has_parent_path(); ++n) {
    above = above.parent_path();
    for (auto &study : stored_studies(above))
      if (seen.insert(study.json.dump()).second) studies.push_back(std::move(study));
  }
  return studies;
}

/// Near the first run of finite elements that has an impact; none without one.
std::vector<StoredStudy> studies_of(const Calibration &c, const Runs &runs) {
  for (const StoredRun *run : runs)
    if (c.facts.at(run->folder).rung && !run->impacts.empty()) return studies_near(run->folder);
  return {};
}

/// What the fit of the law itself leaves open.
void add_doubts_of_fit(Answer &answer) {
  const auto &result = answer.law.result;
  if (!result.converged)
    answer.doubts.push_back(fmt::format("The fit of {} did not converge: {}.", result.law, result.message));
  for (const auto &[name, e] : result.parameters)
    if (!e.identifiable)
      answer.doubts.push_back(fmt::format("{} of {} is not told by these runs: {}.", name, result.law, e.reason));
  if (const auto &gain = result.gain; gain && std::abs(gain->factor - 1) > 2 * gain->stated)
    answer.doubts.push_back(
        fmt::format("The force channel reads {:.3f} of the force that moves the mass, where its gain "
                    "is stated to within {:g}.",
                    gain->factor, gain->stated));
  if (answer.law.left_out.empty())
    answer.doubts.push_back("No run was left out of the fit to try it: how the law predicts is not known.");
  else if (!answer.law.valid_from)
    answer.doubts.push_back(
        fmt::format("The law {} meets no run left out within {:.0f} %.", result.law, 100 * answer.law.tolerance));
  if (answer.foot && !answer.foot->doubt.empty()) answer.doubts.push_back(answer.foot->doubt);
  if (answer.strain && answer.strain->exceeded()) answer.doubts.push_back(answer.strain->sentence);
}

void name_sources(const Calibration &c, Answer &answer, const std::vector<LawError> &fitted) {
  std::set<std::string> rungs;
  std::set<int> meshes;
  for (const auto &e : fitted) {
    const RunFacts &f = c.facts.at(e.folder);
    answer.sources.insert(f.source);
    rungs.insert(f.rung ? word(*f.rung) : f.source == RunSource::measured ? word(f.source) : word(SolvedBy::reduced));
    if (f.mesh) meshes.insert(*f.mesh);
  }
  answer.rungs.assign(rungs.begin(), rungs.end()), answer.meshes.assign(meshes.begin(), meshes.end());
}

/// Solids and specimens have pad and socket, whatever the fitted part of them was; a slider between two dishes has
/// none.
std::optional<AnswerStack> answer_stack(const Answer &answer) {
  const scene::Scene &s = answer.scene;
  if (answer.sources == std::set{RunSource::reduced_model} || !s.bearing.has_pad()) return {};
  const bool on_spring = answer.rungs.size() == 1 && answer.rungs.front() == word(scene::Rung::rim);
  const auto &result = answer.law.result;
  if (result.parameters.count("elastic_slip") + result.fixed.count("elastic_slip") > 0)
    return AnswerStack{s.reduced.elastic_slip, scene::SlipFrom::fit, on_spring};
  return AnswerStack{scene::pad_elastic_slip(s.bearing, s.load.vertical, s.reduced.mu_fast), scene::SlipFrom::bearing,
                     on_spring};
}

} // namespace

std::string Answer::source() const {
  std::string text;
  for (const RunSource source : sources) text += (text.empty() ? "" : " and ") + word(source);
  return text;
}

Answer make_answer(const Calibration &c, const CalibrationOptions &options, const Runs &runs) {
  Runs fitted;
  for (const StoredRun *run : runs)
    if (c.fit.count(run->folder) > 0) fitted.push_back(run);
  const Choice choice = choose(c, options, fitted);
  Answer answer;
  answer.scene = with_fitted(fitted.front()->scene, choice.row.result);
  answer.rim_identity = scene::rim_identity(answer.scene.bearing);
  answer.published_applies = scene::published_pair_applies(answer.scene);
  answer.law = answer_law(choice, answer.scene, runs, c.laws.tolerance);
  answer.foot = answer_foot(c, runs, options.steel_band);
  if (answer.foot) end_at_foot(*answer.foot, answer.law);
  name_sources(c, answer, choice.row.fitted);
  answer.stack = answer_stack(answer);
  answer.table = answer_table(answer.scene, answer.law);
  answer_pair(c, answer);
  answer.strain = answer_strain(c, runs, answer.foot);
  answer.steel_band = options.steel_band;
  const std::vector<StoredStudy> studies = studies_of(c, runs);
  answer.mesh_error = answer_mesh_error(c, runs, studies);
  answer.errors = answer_errors(c, answer, runs, studies);
  answer.doubts = c.doubts;
  add_doubts_of_fit(answer);
  answer.validity = validity_sentence(answer);
  return answer;
}

} // namespace rimpact::calibration

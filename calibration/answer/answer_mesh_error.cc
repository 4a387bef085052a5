#include "calibration/answer/answer_mesh_error.h"

#include "calibration/laws/percent.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact::calibration {

using nlohmann::json;

namespace {

/// "It is judged by study dish-pulse-0.78g, an impact at 0.493 m/s."
std::string judged_by(const nlohmann::json &estimate) {
  const auto speed = estimate.find("study_approach_speed_m_s");
  std::string text = "It is judged by study " + estimate.value("from", "");
  if (speed != estimate.end()) text += fmt::format(", an impact at {:.3g} m/s", speed->get<double>());
  return text + (estimate.value("far", false) ? ", far from the speed of this run." : ".");
}

} // namespace

AnswerMeshError answer_mesh_error(const Calibration &c, const std::vector<const StoredRun *> &runs,
                                  const std::vector<StoredStudy> &studies) {
  AnswerMeshError error;
  bool known = true;
  for (const StoredRun *run : runs) {
    const RunFacts &f = c.facts.at(run->folder);
    if (!f.rung || run->impacts.empty()) continue;
    scene::Scene scene = run->scene;
    scene.model.rung = *f.rung, scene.model.mesh = f.mesh.value_or(scene.model.mesh);
    const auto estimate = error_estimate(scene, run->summary, studies, {run->folder, f.seconds});
    if (!estimate.contains("peak_force_relative") || !estimate["peak_force_relative"].is_number()) {
      if (known) error.sentence = fmt::format("The error of the mesh is {}.", estimate.value("none", "unknown"));
      known = false, error.peak_force.reset(), error.rebound.reset();
      if (estimate.contains("command")) error.find = Finding{estimate["command"], estimate.value("minutes", 0.0)};
      continue;
    }
    const auto at = [&](double value) {
      return ErrorAt{word(run->scene.excitation.kind), run->approach_speed(),
                     run->impacts.front().impact.peak_penetration, value};
    };
    error.by_peak_force.push_back(at(estimate["peak_force_relative"].get<double>()));
    if (estimate.value("rebound_relative", json()).is_number())
      error.by_rebound.push_back(at(estimate["rebound_relative"].get<double>()));
    if (const json &rebound = estimate.value("rebound_relative", json()); known && rebound.is_number())
      error.rebound = std::max(error.rebound.value_or(0), rebound.get<double>());
    if (const double worst = estimate["peak_force_relative"]; known && worst >= error.peak_force.value_or(0)) {
      error.peak_force = worst;
      error.sentence = fmt::format("The mesh leaves the peak force uncertain by about {}, worst in run {}. {}",
                                   percent_up(worst), f.name, judged_by(estimate));
    }
  }
  return error;
}

} // namespace rimpact::calibration

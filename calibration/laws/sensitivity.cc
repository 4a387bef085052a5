#include "calibration/laws/sensitivity.h"
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact::calibration {

namespace {

struct FirstImpact {
  double speed = 0, peak_force = 0; ///< 0: the rim is missed
};

FirstImpact first_impact(const scene::Scene &scene) {
  const auto summary = reduced::simulate_summary(scene);
  if (summary.impacts.empty()) return {};
  return {summary.impacts.front().approach_speed, summary.peak_impact_force.value_or(0)};
}

/// Changes nobody controls: how a record is scaled, which g was meant, how well the equations are integrated.
std::vector<scene::Scene> neighbours(const scene::Scene &scene) {
  std::vector<scene::Scene> all;
  for (const double factor : {0.998, 0.999, 1.001, 1.002}) {
    all.push_back(scene);
    all.back().excitation.scale *= factor;
  }
  all.push_back(scene);
  all.back().load.gravity = scene.load.gravity == 9.81 ? 9.80665 : 9.81;
  all.push_back(scene);
  all.back().reduced.tolerance = std::min(1e-3, 1e3 * scene.reduced.tolerance);
  return all;
}

} // namespace

GrazingReport grazing_report(const scene::Scene &scene) {
  GrazingReport report;
  report.scene = scene.name;
  report.scale = scene.excitation.scale;
  const auto nominal = first_impact(scene);
  report.approach_speed = {nominal.speed, nominal.speed, nominal.speed};
  report.peak_force = {nominal.peak_force, nominal.peak_force, nominal.peak_force};
  for (const auto &neighbour : neighbours(scene)) {
    const auto other = first_impact(neighbour);
    report.approach_speed.low = std::min(report.approach_speed.low, other.speed);
    report.approach_speed.high = std::max(report.approach_speed.high, other.speed);
    report.peak_force.low = std::min(report.peak_force.low, other.peak_force);
    report.peak_force.high = std::max(report.peak_force.high, other.peak_force);
  }
  report.varied = {"amplitude +-0.2 %", "g 9.81 / 9.80665 m/s^2", "integrator tolerance x 1000"};
  report.critical_scale = reduced::critical_scale(scene);
  if (report.critical_scale && scene.excitation.kind == scene::ExcitationKind::ricker)
    report.critical_amplitude_g = *report.critical_scale * scene.excitation.amplitude_g;
  return report;
}

} // namespace rimpact::calibration

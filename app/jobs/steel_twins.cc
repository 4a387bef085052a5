#include "app/jobs/steel_twins.h"

#include "app/jobs/job_runner.h"
#include "calibration/answer/calibration_json.h"
#include "io/files/error.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

using nlohmann::json;

std::optional<Impact> first_impact(const Job &job) {
  const json summary = summary_of(job.folder);
  const json impacts = summary.value("impacts", json::array());
  if (!job.done || impacts.empty() || !impacts.front().value("rebound_speed_m_s", json()).is_number()) return {};
  const auto of = [&](const char *key) { return impacts.front().at(key).get<double>(); };
  return Impact{of("touch_time_s"),      of("release_time_s"), of("direction_deg"),     of("approach_speed_m_s"),
                of("rebound_speed_m_s"), of("peak_force_N"),   of("peak_penetration_m")};
}

const Job *window_of(const std::vector<Job> &jobs, double speed) {
  for (const Job &job : jobs)
    if (job.role == JobRole::window && job.scene.excitation.speed == speed) return &job;
  return nullptr;
}

} // namespace

std::vector<Job> without_twins(const std::vector<Job> &jobs) {
  std::vector<Job> result;
  std::ranges::copy_if(jobs, std::back_inserter(result), [](const Job &job) { return job.role != JobRole::twin; });
  return result;
}

std::optional<calibration::SteelBand> steel_band(const MainTarget &target, const std::vector<Job> &jobs) {
  const scene::Material &steel = target.scene.bearing.rim_steel();
  calibration::SteelBand band{.rate = fast_rate(steel),
                              .assumed = !steel.knows_rate(),
                              .runs_are_static = !steel.knows_rate(),
                              .twins = {},
                              .calibration = {}};
  for (const Job &job : jobs) {
    if (job.role != JobRole::twin) continue;
    const Job *window = window_of(jobs, job.scene.excitation.speed);
    const auto twin = first_impact(job), run = window ? first_impact(*window) : std::nullopt;
    if (!twin || !run) continue;
    const auto of_twin = foot_report_in(summary_of(job.folder), job.folder),
               of_run = foot_report_in(summary_of(window->folder), window->folder);
    band.twins.push_back({.speed = job.scene.excitation.impact_speed(),
                          .static_steel = band.runs_are_static ? *run : *twin,
                          .fast = band.runs_are_static ? *twin : *run,
                          .static_foot = band.runs_are_static ? of_run : of_twin,
                          .fast_foot = band.runs_are_static ? of_twin : of_run});
  }
  if (band.twins.empty()) return {};
  std::ranges::sort(band.twins, {}, &calibration::SteelTwin::speed);
  return band;
}

void fit_twins(const std::vector<Job> &jobs, const std::string &law, const std::string &calibration,
               calibration::SteelBand &band, Console &console) {
  std::vector<std::string> folders;
  for (const Job &job : jobs)
    if (job.role == JobRole::twin && first_impact(job)) folders.push_back(job.folder);
  const std::string name = band.runs_are_static ? "fast" : "static";
  try {
    calibration::CalibrationOptions options;
    options.laws = {law};
    const auto fitted = calibration::calibrate(folders, options);
    calibration::write_calibration(fitted, calibration + "/" + name);
    calibration::check_gate(fitted);
    band.calibration = name;
  } catch (const Error &error) {
    console.warn(fmt::format("no law of the {} steel: {}", name, error.what()));
  }
}

} // namespace rimpact::app

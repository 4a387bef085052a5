#include "app/jobs/main_jobs.h"

#include "fe_contact/planning/plan_parts.h"
#include "io/files/error.h"
#include "scene/toml_writer.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <limits>
#include <set>

namespace rimpact::app {
namespace {

/// A built-in scene with the target's bearing, load and settings.
scene::Scene for_target(const char *built_in, const MainTarget &target, const std::string &assignment) {
  scene::Scene scene = scene::load_scene(built_in, {assignment});
  scene.bearing = target.scene.bearing;
  scene.load = target.scene.load, scene.load_remark = target.scene.load_remark;
  scene.model = target.scene.model;
  scene.reduced = target.scene.reduced;
  scene.reduced.forget_fit(); // a reference run is of no fitted law
  return scene;
}

/// Whether a pulse is the thesis's own, whatever finite-element settings run it.
bool is_thesis(const scene::Scene &pulse, const char *built_in) {
  scene::Scene thesis = scene::load_scene(built_in);
  thesis.model = pulse.model;
  thesis.name = pulse.name;
  thesis.load_remark = pulse.load_remark; // whether the load is given is no number
  return scene::to_toml(thesis) == scene::to_toml(pulse);
}

PulseScales scales_of(const char *built_in, const MainTarget &target, const std::optional<SpeedRange> &asked) {
  const scene::Scene pulse = for_target(built_in, target, "excitation.scale=1.0");
  if (asked || !is_thesis(pulse, built_in)) return pulse_scales(pulse, asked.value_or(SpeedRange{}));
  return {.pulses = {{1.10, 0, true}, {1.05, 0, true}, {1.0, 0, false}}};
}

/// The windows' scene with steel that knows its rate where theirs does not, and the other way round.
scene::Scene with_other_steel(scene::Scene window) {
  const bool is_fast = window.bearing.rim_steel().knows_rate();
  for (const auto &[table, steel] : steels_of(window.bearing))
    if (is_fast)
      steel->rate.model = scene::RateModel::none;
    else
      steel->rate = fast_rate(*steel);
  return window;
}

/// Of the fastest, the middle and the slowest window that the rim is expected to stop; fewer where there are fewer.
std::vector<Job> twins_of(const std::vector<Job> &jobs, const std::string &folder) {
  std::vector<const Job *> windows;
  for (const Job &job : jobs)
    if (job.role == JobRole::window &&
        planning::depth_of_impact(job.scene, job.scene.excitation.speed) < job.scene.bearing.rim.thickness)
      windows.push_back(&job);
  std::ranges::sort(windows, std::greater(), [](const Job *job) { return job->scene.excitation.speed; });
  std::vector<Job> result;
  for (const std::size_t k : std::set<std::size_t>{0, windows.size() / 2, windows.size() - 1}) {
    if (k >= windows.size()) continue;
    const std::string name =
        windows[k]->name + (windows[k]->scene.bearing.rim_steel().knows_rate() ? "-static" : "-fast");
    result.push_back({.name = name,
                      .role = JobRole::twin,
                      .scene = with_other_steel(windows[k]->scene),
                      .folder = folder + "/twins/" + name});
    result.back().scene.name = name;
  }
  return result;
}

/// From 0, the largest, on: each the farthest from those before it, by the logarithm.
std::vector<double> spread(std::vector<double> speeds) {
  std::sort(speeds.rbegin(), speeds.rend());
  const auto distance = [&](std::size_t n, double speed) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < n; ++k) least = std::min(least, std::abs(std::log(speeds[k] / speed)));
    return least;
  };
  for (std::size_t n = 1; n < speeds.size(); ++n) {
    const auto next = std::max_element(speeds.begin() + n, speeds.end(),
                                       [&](double a, double b) { return distance(n, a) < distance(n, b); });
    std::rotate(speeds.begin() + n, next, next + 1);
  }
  return speeds;
}

} // namespace

scene::StrainRate fast_rate(const scene::Material &steel) {
  if (steel.knows_rate()) return steel.rate;
  scene::StrainRate fast = steel.has_grade() ? steel.rate : scene::StrainRate{}; // else mild steel's
  fast.model = scene::RateModel::cowper_symonds;
  return fast;
}

MainJobs main_jobs(const MainTarget &target, const MainChoices &choices, const std::string &folder) {
  MainJobs result;
  const auto add = [&](const std::string &name, JobRole role, scene::Scene scene) {
    scene.name = name;
    scene.validate();
    result.jobs.push_back({.name = name, .role = role, .scene = std::move(scene), .folder = folder + "/runs/" + name});
  };
  for (const double speed : spread(choices.speeds)) {
    const std::string name = "window-" + in_a_name(speed);
    if (std::ranges::any_of(result.jobs, [&](const Job &job) { return job.name == name; }))
      throw InputError(
          fmt::format("--speeds: {:g} m/s stands there twice, to the four decimals of a run's name", speed));
    add(name, JobRole::window, for_target("impact-window", target, fmt::format("excitation.speed_m_per_s={}", speed)));
  }
  constexpr const char *pulses[] = {"ricker-0.78g-1.0s", "ricker-0.38g-1.5s"};
  std::vector<PulseScales> scales;
  if (!choices.windows_only)
    for (const char *pulse : pulses) {
      scales.push_back(scales_of(pulse, target, choices.pulse_speeds));
      for (const auto &sentence : scales.back().left_out) result.left_out.push_back(sentence);
    }
  if (choices.bidirectional) // without a plane of symmetry it takes longest
    add("pulse-bidirectional", JobRole::predict, for_target("pulse-bidirectional", target, "excitation.scale=1.0"));
  for (std::size_t k = 0; k < 3; ++k) // the hardest of each pulse first
    for (std::size_t p = 0; p < scales.size(); ++p) {
      if (k >= scales[p].pulses.size()) continue;
      const auto &[scale, speed, fitted] = scales[p].pulses[k];
      const std::string text = in_a_name(scale);
      add(fmt::format("{}-x{}", pulses[p], text), fitted ? JobRole::fit : JobRole::predict,
          for_target(pulses[p], target, "excitation.scale=" + text));
    }
  if (choices.twins.value_or(!target.built_in) && target.scene.bearing.steel.yield)
    for (Job &twin : twins_of(result.jobs, folder)) result.jobs.push_back(std::move(twin));
  return result;
}

void sort_for_tables(std::vector<Job> &jobs) {
  const auto place = [](const Job &job) {
    const bool window = job.role == JobRole::window;
    return std::pair(job.role == JobRole::twin ? 2 : window ? 1 : 0, window ? -job.scene.excitation.speed : 0.0);
  };
  std::ranges::stable_sort(jobs, {}, place);
}

} // namespace rimpact::app

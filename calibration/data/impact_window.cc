#include "calibration/data/impact_window.h"
#include "calibration/data/measured_cutter.h"
#include "calibration/data/measured_name.h"
#include "calibration/data/measured_run.h"
#include "calibration/data/series.h"
#include "calibration/data/window_cutter.h"
#include "io/files/require.h"
#include "reduced_models/bearings/pad_on_dish.h"
#include "responses/kept_run.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>

namespace rimpact::calibration {

namespace {

/// A rim touched again counts as one impact within this time [s]: walls chatter, bearings do not.
constexpr double chatter_time = 2e-3;

void complete_velocities(Response &response) {
  for (const char *axis : {"x", "y", "z"}) {
    const std::string u = std::string("displacement_") + axis, v = std::string("velocity_") + axis;
    if (response.has(u) && !response.has(v))
      response.series(v) = differentiate(response.series("time"), response.series(u));
  }
}

std::vector<Impact> merge_chatter(const std::vector<Impact> &impacts) {
  std::vector<Impact> merged;
  for (const auto &next : impacts) {
    if (merged.empty() || next.touch_time - merged.back().release_time > chatter_time) {
      merged.push_back(next);
      continue;
    }
    auto &impact = merged.back();
    impact.release_time = next.release_time;
    impact.rebound_speed = next.rebound_speed;
    impact.peak_force = std::max(impact.peak_force, next.peak_force);
    impact.peak_penetration = std::max(impact.peak_penetration, next.peak_penetration);
  }
  return merged;
}

} // namespace

void WindowOptions::validate() const {
  require_bound(lead >= 0 && lead <= 1, "lead", lead, "in 0..1 m");
  require_bound(tail > 0, "tail", tail, "> 0 s");
  require_bound(force_threshold >= 0 && force_threshold <= 0.5, "force_threshold", force_threshold, "in 0..0.5");
  require_bound(stated_speed_error > 0, "stated_speed_error", stated_speed_error, "> 0");
  require_bound(minimum_samples >= 4, "minimum_samples", minimum_samples, ">= 4");
  require_bound(grazing_overshoot >= 0, "grazing_overshoot", grazing_overshoot, ">= 0");
}

double StoredRun::peak_force() const {
  double peak = 0;
  for (const auto &w : impacts) peak = std::max(peak, w.peak);
  return peak;
}

double StoredRun::approach_speed() const {
  double speed = 0;
  for (const auto &w : impacts) speed = std::max(speed, w.impact.approach_speed);
  return speed;
}

StoredRun make_run(const std::string &folder, const scene::Scene &scene, Response response,
                   const WindowOptions &options) {
  options.validate();
  StoredRun run{.folder = folder,
                .scene = scene,
                .response = std::move(response),
                .summary = {},
                .impacts = {},
                .uncertainty = {},
                .clock_error = 0,
                .notes = {},
                .noise = {},
                .doubts = {}};
  run.scene.reduced.forget_foot(); // laws are fitted to all that it holds
  if (run.response.size() < 2) throw DataError(folder + ": the response has fewer than two samples");
  if (options.measured) {
    cut_measured(run, options);
    return run;
  }
  complete_velocities(run.response);
  summarise_response(run.response, run.summary);
  run.summary.impacts = merge_chatter(run.summary.impacts);
  if (!scene.excitation.is_dynamic()) {
    run.notes.push_back("a quasi-static path holds no impact");
    return run;
  }
  const WindowCutter cutter(run, options);
  for (std::size_t i = 0; i < run.summary.impacts.size(); ++i) {
    std::string reason;
    if (auto window = cutter.cut(i, reason))
      run.impacts.push_back(std::move(*window));
    else
      run.notes.push_back(fmt::format("impact at {:.4f} s left out: {}", run.summary.impacts[i].touch_time, reason));
  }
  return run;
}

StoredRun read_run(const std::string &folder, const WindowOptions &options) {
  namespace fs = std::filesystem;
  if (is_mapping(folder)) return read_measured(folder, options);
  if (!fs::is_directory(folder))
    throw DataError(folder + ": not a run folder; logs and scenes lie beside those of rimpact main, give the folders "
                             "alone (runs/window-*/)");
  if (!fs::exists(fs::path(folder) / "scene.toml"))
    throw DataError(folder + ": no scene.toml, so its bearing and load are unknown");
  auto scene = scene::load_scene((fs::path(folder) / "scene.toml").string());
  if (scene.bearing.has_interface())
    throw InputError(
        fmt::format("{}: its slider is two halves (slider.mu_interface {:g}), and the laws of a rim and the "
                    "reduced model that has them know a slider of one piece",
                    folder, *scene.bearing.slider.mu_interface));
  const nlohmann::json summary = read_summary(folder);
  const auto solver = word_in<SolvedBy>(summary, "rung", folder);
  // The reference has the pad's and the socket's terms by itself; what is fitted to it must have them too.
  const auto rung = solver ? rung_of(*solver) : std::nullopt;
  if (rung && has_dish(*rung)) reduced::add_stack_terms(scene);
  StoredRun run = make_run(folder, scene, read_response(folder), options);
  run.summary.status = word_in<RunStatus>(summary, "status", folder).value_or(RunStatus::done);
  run.summary.rung = solver.value_or(SolvedBy::reduced);
  if (run.summary.status != RunStatus::done)
    run.notes.push_back(fmt::format("the run is {}: only what it holds is used", word(run.summary.status)));
  return run;
}

} // namespace rimpact::calibration

#include "calibration/data/measured_run.h"
#include "calibration/data/channels.h"
#include "calibration/data/consistency.h"
#include "calibration/data/force_clock.h"
#include "calibration/data/measured_name.h"
#include "io/files/error.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::calibration {

namespace {
namespace fs = std::filesystem;

/// A scene file beside the mapping, or a built-in scene.
std::string scene_beside(const std::string &name, const fs::path &folder) {
  return fs::exists(folder / name) ? (folder / name).string() : name;
}

/// What a planar test has not measured is zero; the gap follows from the travel.
void complete(Response &response, double lateral_capacity) {
  for (const char *signal : {"displacement_y", "impact_x", "impact_y"})
    if (!response.has(signal)) response.series(signal).assign(response.size(), 0.0);
  for (const char *axis : {"x", "y"})
    if (const std::string force = std::string("force_") + axis; !response.has(force))
      response.series(force) = response.series(std::string("impact_") + axis);
  auto &gap = response.series("gap");
  gap.clear();
  for (std::size_t i = 0; i < response.size(); ++i)
    gap.push_back(lateral_capacity -
                  std::hypot(response.series("displacement_x")[i], response.series("displacement_y")[i]));
}

/// A window's scene that says another speed than the flight before its touch: what is compared with the record must fly
/// at the record's own. One that begins at touch has the scene's.
void take_own_speed(StoredRun &run) {
  constexpr double alike = 0.05, sure = 5; // of the stated speed; standard errors
  if (!run.is_window() || run.impacts.empty()) return;
  const ImpactWindow &w = run.impacts.front();
  auto &excitation = run.scene.excitation;
  const double stated = excitation.impact_speed(), own = w.impact.approach_speed,
               error = std::sqrt(w.measurement->start_factor.row(1).squaredNorm());
  if (!(own > 0) || std::abs(own - stated) <= std::max(alike * stated, sure * error)) return;
  excitation.speed *= own / stated;
  run.doubts.push_back(fmt::format("its scene says {:.4g} m/s, the record comes to the rim at {:.4g} m/s: the record's "
                                   "own speed is taken (excitation.speed_m_per_s)",
                                   stated, own));
}

} // namespace

StoredRun read_measured(const std::string &path, const WindowOptions &options) {
  const auto name = measured_name(path);
  const Mapping mapping = read_mapping(name->file);
  const TestPart part = named_part(mapping, *name, tests_of(mapping));
  const fs::path folder = fs::path(name->file).parent_path();
  const auto scene = scene::load_scene(scene_beside(mapping.scene, folder), part.overrides);
  auto [response, unit_of_force, notes] = read_channels(mapping, part);
  complete(response, scene.bearing.lateral_capacity());
  require_clock(response, scene, path);
  WindowOptions own = options;
  own.measured = true;
  if (const auto &stated = mapping.uncertainty)
    own.stated_speed_error = stated->speed, own.stated_clock_error = stated->time;
  own.force_threshold = std::max(own.force_threshold, mapping.force_noise);
  double clock_error = 0;
  if (std::any_of(mapping.columns.begin(), mapping.columns.end(), [](const Column &c) { return c.estimate_lag; })) {
    const ForceClock clock = align_force(path, scene, response, own);
    clock_error = clock.unsure;
    own.stated_clock_error = std::hypot(own.stated_clock_error, clock_error);
    notes.push_back(clock.sentence());
  }
  StoredRun run = make_run(path, scene, std::move(response), own);
  run.uncertainty = mapping.uncertainty, run.clock_error = clock_error;
  run.noise.insert(run.noise.begin(), notes.begin(), notes.end());
  require_consistent(run, unit_of_force);
  take_own_speed(run);
  return run;
}

} // namespace rimpact::calibration

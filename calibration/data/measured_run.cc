#include "calibration/data/measured_run.h"
#include "calibration/data/mapping.h"
#include "files/error.h"
#include "files/file.h"
#include "responses/response_files.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::calibration {

namespace {
namespace fs = std::filesystem;

/// A scene file beside the mapping, or a built-in scene.
std::string scene_beside(const std::string &name, const fs::path &folder) {
  return fs::exists(folder / name) ? (folder / name).string() : name;
}

void require_columns(const Response &response, const Mapping &mapping, const std::string &table,
                     const std::vector<std::string> &headers) {
  for (const auto &column : mapping.columns)
    if (!response.has(column.signal))
      throw DataError(fmt::format("{}: no column \"{}\" ({}); the header, after skip_lines = {}, names \"{}\"", table,
                                  column.header, column.signal, mapping.skip_lines, fmt::join(headers, "\", \"")));
  for (const char *needed : {"time", "displacement_x"})
    if (!response.has(needed)) throw DataError(fmt::format("{}: {} has no column", table, needed));
  if (!response.has("impact_x") && !response.has("impact_y"))
    throw DataError(table + ": neither impact_x nor impact_y, the rim's force, has a column");
  const auto &time = response.series("time");
  for (std::size_t i = 1; i < time.size(); ++i)
    if (time[i] <= time[i - 1])
      throw DataError(
          fmt::format("{}: time runs from {:g} s to {:g} s at sample {}", table, time[i - 1], time[i], i + 1));
}

std::string unit_of_force(const Mapping &mapping) {
  for (const auto &column : mapping.columns)
    if (column.signal == "impact_x" || column.signal == "impact_y") return column.unit;
  return {};
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
  const Mapping mapping = read_mapping(path);
  const fs::path folder = fs::path(path).parent_path();
  const auto scene = scene::load_scene(scene_beside(mapping.scene, folder), mapping.overrides);
  const std::string table = (folder / mapping.file).string();
  std::vector<std::string> headers;
  auto response = parse_columns(
      read_file(table), table,
      [&](std::string_view header) -> CsvTarget {
        headers.emplace_back(header);
        for (const auto &c : mapping.columns)
          if (header == c.header) return {c.signal, c.factor * c.si, c.zero};
        return {};
      },
      static_cast<std::size_t>(mapping.skip_lines));
  require_columns(response, mapping, table, headers);
  const bool comma = response.meta.erase(decimal_comma) > 0;
  complete(response, scene.bearing.lateral_capacity());
  require_clock(response, scene, table);
  WindowOptions own = options;
  own.measured = true;
  if (mapping.uncertainty) {
    own.stated_speed_error = mapping.uncertainty->speed;
    own.stated_clock_error = mapping.uncertainty->time;
  }
  own.force_threshold = std::max(own.force_threshold, mapping.force_noise);
  StoredRun run = make_run(path, scene, std::move(response), own);
  run.uncertainty = mapping.uncertainty;
  if (comma) run.noise.push_back(table + " is read with a decimal comma");
  require_consistent(run, unit_of_force(mapping));
  take_own_speed(run);
  return run;
}

} // namespace rimpact::calibration

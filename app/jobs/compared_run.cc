#include "app/jobs/compared_run.h"

#include "app/jobs/job_runner.h"
#include "calibration/data/measured_name.h"
#include "calibration/data/measured_run.h"
#include "io/files/digest.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "responses/choices.h"
#include "scene/scene.h"
#include "scene/toml_writer.h"
#include <array>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

using nlohmann::json;

/// Signals every comparison reads, and the CSV columns that hold them.
void require_signals(const ComparedRun &item) {
  constexpr std::array needed{std::pair{"displacement_x", "ux_m"}, std::pair{"displacement_y", "uy_m"},
                              std::pair{"force_x", "Fx_N"},        std::pair{"force_y", "Fy_N"},
                              std::pair{"impact_x", "Ix_N"},       std::pair{"impact_y", "Iy_N"}};
  for (const auto &[signal, column] : needed)
    if (!item.response.has(signal))
      throw DataError(
          fmt::format("{}: no signal {} (CSV column {}); compare needs time_s, ux_m, uy_m, Fx_N, Fy_N, Ix_N and Iy_N",
                      item.path, signal, column));
}

/// With every default written out, so that a scene of an older version differs in what was changed only.
std::string resolved(const std::string &text, const std::string &path) {
  try {
    return scene::to_toml(scene::parse_scene(text, path));
  } catch (const Error &) { // a record that is no longer there: its text tells as much
    return text;
  }
}

/// What the scene's load does not say: a building's bearings carry shares of it.
std::string carried(const json &summary, const std::string &folder) {
  const auto building = summary.find("building");
  if (building == summary.end()) return "one bearing";
  double weight = 0;
  for (const auto &bearing : building->at("bearings")) weight += bearing.value("static_normal_force_N", 0.0);
  std::string tables;
  std::error_code ignored;
  for (const char *name : {"nodes.csv", "elements.csv", "diaphragms.csv"})
    if (const auto path = std::filesystem::path(folder) / name; std::filesystem::exists(path, ignored))
      tables += read_file(path.string());
  constexpr int short_hash = 8; // of the frame: tells two of the same weight apart
  return fmt::format("{} bearings under {:.4g} kN, frame {}", building->at("bearings").size(), weight / 1e3,
                     sha256(tables).substr(0, short_hash));
}

/// What the run's summary says of itself, where there is one.
void read_summary_of(ComparedRun &item) {
  std::error_code ignored;
  if (!std::filesystem::exists(std::filesystem::path(item.path) / "summary.json", ignored)) return;
  const json summary = summary_of(item.path);
  item.carried = carried(summary, item.path);
  item.solver = summary.value("rung", "");
  if (const std::string status = summary.value("status", word(RunStatus::done)); status != word(RunStatus::done))
    item.doubt = fmt::format("this run is {} ({}): its figures are those up to there", status,
                             summary.value("reason", "no reason is given"));
  else if (const auto beyond = summary.find("beyond_rim"); beyond != summary.end() && *beyond == true)
    item.doubt = "its rim was pressed deeper than it is thick: its forces are no result";
}

/// A bare table's force is that of the rim only where it is nil off it: noise would be taken for contact.
void require_free_flight(const ComparedRun &item) {
  constexpr double small = 0.01, most = 0.5; // of the peak; of the samples that bear force
  const auto &x = item.response.series("impact_x"), &y = item.response.series("impact_y");
  double peak = 0;
  for (std::size_t i = 0; i < x.size(); ++i) peak = std::max(peak, std::hypot(x[i], y[i]));
  int n_pressed = 0, n_small = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double force = std::hypot(x[i], y[i]);
    n_pressed += force > 0, n_small += force > 0 && force < small * peak;
  }
  constexpr int few = 20;
  if (n_small > few && n_small > most * n_pressed)
    throw DataError(
        fmt::format("{}: the rim bears less than 1 % of its peak force in {} of {} samples with force: noise off the "
                    "rim would be taken for contact; describe the table by a mapping file, which cuts it",
                    item.path, n_small, n_pressed));
}

/// A rim pushes its slider back: a force that pushes it outwards has the wrong sign.
std::string doubt_of_sign(const Response &response) {
  const auto &ix = response.series("impact_x"), &iy = response.series("impact_y");
  const auto &ux = response.series("displacement_x"), &uy = response.series("displacement_y");
  std::size_t hardest = 0;
  double peak = 0;
  for (std::size_t i = 0; i < ix.size(); ++i)
    if (const double size = std::hypot(ix[i], iy[i]); size > peak) peak = size, hardest = i;
  if (!(ix[hardest] * ux[hardest] + iy[hardest] * uy[hardest] > 0)) return "";
  return fmt::format("its rim pushes outwards with {:.4g} kN at {:.4g} s, where a rim pushes back: its forces have the "
                     "wrong sign",
                     peak / 1e3, response.series("time")[hardest]);
}

} // namespace

ComparedRun read_compared(const std::string &path) {
  namespace fs = std::filesystem;
  ComparedRun item;
  item.path = path;
  if (calibration::is_mapping(path)) {
    auto run = calibration::read_measured(path, {});
    item.scene = scene::to_toml(run.scene);
    item.response = std::move(run.response);
  } else {
    item.response = read_response(path);
    const fs::path beside = fs::path(path) / "scene.toml";
    std::error_code ignored;
    if (fs::exists(beside, ignored))
      item.scene = read_file(beside.string());
    else if (const auto kept = item.response.meta.find("scene"); kept != item.response.meta.end())
      item.scene = kept->second;
    if (!item.scene.empty()) item.scene = resolved(item.scene, path);
    read_summary_of(item);
  }
  require_signals(item);
  if (item.scene.empty()) require_free_flight(item);
  if (item.doubt.empty()) item.doubt = doubt_of_sign(item.response);
  return item;
}

std::vector<Difference> differences_between(const ComparedRun &a, const ComparedRun &b) {
  auto found = differences(a.scene, b.scene);
  const std::string reduced = word(SolvedBy::reduced);
  const auto unread = [&](const Difference &each) {
    const bool solids = each.key.starts_with("model."), law = each.key.starts_with("reduced.");
    return (solids && (a.solver == reduced || b.solver == reduced)) ||
           (law && (a.solver != reduced || b.solver != reduced));
  };
  if (!a.solver.empty() && !b.solver.empty()) {
    std::erase_if(found, unread);
    if (a.solver != b.solver) found.push_back({"solved by", a.solver, b.solver, true});
  }
  return found;
}

} // namespace rimpact::app

#include "calibration/answer/finding.h"
#include "calibration/answer/kept_errors.h"
#include "io/files/text.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::calibration {
namespace {

namespace fs = std::filesystem;

/// Processor time over rung rim's in kept studies (data/studies, mesh 1): windows, motions.
struct CostRatio {
  double window, motion;
};
constexpr CostRatio cost_of_dish{5.4, 11}, cost_of_full{10, 25};

CostRatio of_rung(scene::Rung rung) {
  return rung == scene::Rung::rim ? CostRatio{1, 1} : rung == scene::Rung::full ? cost_of_full : cost_of_dish;
}

fs::path folder_of(const StoredRun &run) {
  return fs::path(run.folder).lexically_normal();
}

std::string scene_of(const StoredRun &run) {
  return (folder_of(run) / "scene.toml").string();
}

/// "-o FOLDER-OF-THE-RUNS/NAME-RUN".
std::string beside(const StoredRun &run, const std::string &name) {
  const fs::path folder = folder_of(run),
                 last = folder.has_filename() ? folder.filename() : folder.parent_path().filename();
  return fmt::format("-o {}", (folder / ".." / (name + "-" + last.string())).lexically_normal().string());
}

double minutes(double runs, const RunFacts &facts) {
  return runs * facts.seconds / 60;
}

/// A rim curve along one path takes 65 s of processor time on mesh 1 (tests/verification/rim_curve.txt has both paths),
/// and 6.2 times as long a level on.
double curve_minutes(int mesh) {
  constexpr double seconds = 65, cost_a_level = 6.2;
  return seconds / 60 * std::pow(cost_a_level, mesh - 1);
}

bool is_felt(const scene::Assumption &assumed) {
  const auto starts = [&](const char *part) { return assumed.key.starts_with(part); };
  const bool steel = starts("material.steel.E_") || starts("material.steel.yield") || starts("material.steel.tangent");
  const auto value = to_number(assumed.value);
  return value && *value > 0 && (starts("rim.h") || starts("rim.t") || steel);
}

} // namespace

Finding find_step(const StoredRun &run, const RunFacts &facts) {
  const double step = 1e3 * (run.scene.model.step > 0 ? run.scene.model.step : planned_step);
  return {fmt::format("rimpact study {} --axes step --steps {:g},{:g} {}", scene_of(run), step, step / 2,
                      beside(run, "study-step")),
          minutes(1 + 2, facts)}; // half the step, twice the time
}

Finding find_rung(const StoredRun &run, const RunFacts &facts) {
  const auto own = facts.rung.value_or(scene::Rung::rim);
  double runs = 0;
  std::string words;
  const auto cost = [&](scene::Rung rung) { return run.is_window() ? of_rung(rung).window : of_rung(rung).motion; };
  for (const auto rung : {own, scene::Rung::full})
    runs += cost(rung) / cost(own), words += (words.empty() ? "" : ",") + word(rung);
  return {fmt::format("rimpact study {} --axes rung --rungs {} {}", scene_of(run), words, beside(run, "study-rung")),
          minutes(runs, facts)};
}

std::optional<Finding> find_geometry(const StoredRun &run, const RunFacts &facts,
                                     const std::vector<scene::Assumption> &keys) {
  const auto felt = std::find_if(keys.begin(), keys.end(), is_felt);
  if (felt == keys.end()) return {};
  constexpr int rims = 3;
  const double value = to_number(felt->value).value(), around = 0.1 * value;
  return Finding{fmt::format("rimpact geometry {} --vary {}={:g}:{:g} --at speed={:.3g} --set load.mass_kg={:.6g}",
                             scene_of(run), felt->key, value - around, value + around, run.approach_speed(),
                             run.scene.load.mass),
                 rims * curve_minutes(facts.mesh.value_or(1)) + minutes(1, facts)};
}

bool takes_part(const std::string &key, scene::Rung rung) {
  if (rung != scene::Rung::rim) return true;
  return !(key.starts_with("pad.") || key.starts_with("foot.") || key.starts_with("material.ertalyte.") ||
           (key.starts_with("contact.") && key != "contact.rim"));
}

} // namespace rimpact::calibration

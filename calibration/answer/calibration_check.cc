#include "calibration/answer/calibration_check.h"
#include "calibration/answer/answer.h"
#include "calibration/fit/shooting.h"
#include "io/files/error.h"
#include "scene/doubts.h"
#include "scene/element_doubts.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <map>

namespace rimpact::calibration {

namespace {

/// First setting in which two scenes differ that one set of parameters must share; empty when there is none.
std::string difference(const scene::Scene &a, const scene::Scene &b) {
  const auto number = [](const char *name, double x, double y) {
    return x == y ? std::string() : fmt::format("{} {:g} and {:g}", name, x, y);
  };
  const auto text = [](const char *name, const std::string &x, const std::string &y) {
    return x == y ? std::string() : fmt::format("{} \"{}\" and \"{}\"", name, x, y);
  };
  const auto &r = a.reduced, &s = b.reduced;
  for (const auto &found :
       {a.bearing == b.bearing
            ? std::string()
            : fmt::format("bearings \"{}\" and \"{}\" of different dimensions", a.bearing.name, b.bearing.name),
        number("load.mass_kg", a.load.mass, b.load.mass),
        number("load.vertical_kN", a.load.vertical / 1e3, b.load.vertical / 1e3),
        number("load.gravity_m_per_s2", a.load.gravity, b.load.gravity),
        text("reduced.model", word(r.model), word(s.model)),
        text("reduced.impact_law", r.impact_law->name, s.impact_law->name),
        text("reduced.friction", word(r.friction), word(s.friction)),
        text("reduced.normal_force", word(r.normal_force), word(s.normal_force)),
        number("reduced.mu_fast", r.mu_fast, s.mu_fast), number("reduced.mu_slow", r.mu_slow, s.mu_slow)})
    if (!found.empty()) return found;
  return {};
}

ImpactCheck check_impact(const StoredRun &run, const ImpactWindow &w, const scene::Scene &scene) {
  const Shot shot = shoot(scene, w);
  ImpactCheck check{};
  check.touch_time = w.impact.touch_time;
  check.approach_speed = w.impact.approach_speed;
  check.peak_force_error = shot.peak / w.peak - 1;
  check.rebound_error = (shot.rebound_speed - w.impact.rebound_speed) / w.impact.approach_speed;
  check.normalised_force =
      w.impact.peak_force / (w.impact.approach_speed * std::sqrt(scene.reduced.k_i * run.scene.load.mass));
  check.grazing = w.grazing;
  check.dented = w.dented;
  return check;
}

} // namespace

void require_distinct(const std::vector<std::string> &folders) {
  namespace fs = std::filesystem;
  std::map<std::string, std::string> seen; // by where it really is
  for (const auto &folder : folders) {
    std::error_code unknown;
    const auto place = fs::weakly_canonical(folder, unknown).string();
    const auto [other, fresh] = seen.insert({unknown ? folder : place, folder});
    if (!fresh)
      throw InputError(fmt::format(
          "{} and {} are the same run: named twice it would count twice, and every interval would be too small",
          other->second, folder));
  }
}

void require_distinct(const std::vector<StoredRun> &runs) {
  for (std::size_t i = 0; i < runs.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto same = [&a = runs[i].response, &b = runs[j].response](const char *signal) {
        return a.has(signal) == b.has(signal) && (!a.has(signal) || a.series(signal) == b.series(signal));
      };
      constexpr std::array signals{"time", "displacement_x", "displacement_y", "impact_x", "impact_y"};
      if (std::all_of(signals.begin(), signals.end(), same))
        throw InputError(
            fmt::format("{} and {} hold the same response, sample by sample: a copy would count twice, and "
                        "every interval would be too small",
                        runs[j].folder, runs[i].folder));
    }
}

void require_same_device(const std::vector<StoredRun> &runs) {
  for (std::size_t i = 1; i < runs.size(); ++i)
    if (const auto found = difference(runs[0].scene, runs[i].scene); !found.empty())
      throw InputError(
          fmt::format("{} and {} cannot be calibrated together: {}", runs[0].folder, runs[i].folder, found));
}

RunCheck check_run(const StoredRun &run, const FitResult &result, const FitOptions &options, bool fitted) {
  RunCheck check;
  const double L_c = run.scene.bearing.lateral_capacity();
  const auto scene = with_fitted(run.scene, result);
  check.history = compare(run.response, history_of(run, scene), L_c);
  if (scene::published_pair_applies(run.scene)) {
    auto published = run.scene;
    published.reduced.k_i = published_k_i;
    published.reduced.restitution = published_e;
    published.reduced.impact_law = &laws::default_law(); // what the pair was published for
    check.published = compare(run.response, history_of(run, published), L_c);
  }
  bool any_clear = false;
  for (const auto &w : run.impacts) any_clear = any_clear || !w.grazing;
  for (const auto &w : run.impacts) {
    check.impacts.push_back(check_impact(run, w, scene));
    check.impacts.back().fitted = fitted && (!w.grazing || options.keep_grazing || !any_clear);
  }
  check.notes = run.notes;
  return check;
}

} // namespace rimpact::calibration

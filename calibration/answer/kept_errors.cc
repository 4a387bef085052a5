#include "calibration/answer/kept_errors.h"
#include "scene/bearing_catalogue.h"
#include "scene/rim_identity.h"
#include <algorithm>
#include <array>
#include <cmath>

namespace rimpact::calibration {
namespace {

using nlohmann::json;

/// Windows with weight and friction, mesh 1.
struct WindowOfRungs {
  double speed;
  scene::Rung rung;
  double deep, peak_force, rebound; ///< [m], [N], [-]
};
struct KeptWindows {
  const char *bearing;
  std::array<WindowOfRungs, 6> windows;
};
/// tests/verification/windows_of_rungs.txt and windows_of_rungs_dcfp.txt.
constexpr std::array kept_windows{KeptWindows{"shfps-225",
                                              {{{0.10, scene::Rung::rim, 0.767e-3, 569.0e3, 0.7061},
                                                {0.10, scene::Rung::rigid_dish, 0.740e-3, 559.0e3, 0.7086},
                                                {0.10, scene::Rung::full, 0.751e-3, 555.8e3, 0.7172},
                                                {0.50, scene::Rung::rim, 8.621e-3, 1530.6e3, 0.2650},
                                                {0.50, scene::Rung::rigid_dish, 8.313e-3, 1486.3e3, 0.2414},
                                                {0.50, scene::Rung::full, 8.342e-3, 1481.1e3, 0.2466}}}},
                                  KeptWindows{"dcfp-155",
                                              {{{0.10, scene::Rung::rim, 1.775e-3, 253.9e3, 0.3849},
                                                {0.10, scene::Rung::rigid_dish, 1.742e-3, 261.3e3, 0.4032},
                                                {0.10, scene::Rung::full, 1.785e-3, 248.3e3, 0.4034},
                                                {0.50, scene::Rung::rim, 14.764e-3, 1034.8e3, 0.1911},
                                                {0.50, scene::Rung::rigid_dish, 14.503e-3, 1030.0e3, 0.1974},
                                                {0.50, scene::Rung::full, 14.777e-3, 1052.1e3, 0.2062}}}}};

double off(double value, double reference) {
  return std::abs(value / reference - 1);
}

/// Of two rows of a study, whose errors are both against its reference.
double off(const json &row, const json &reference, const char *error) {
  return off(1 + row.value(error, 0.0), 1 + reference.value(error, 0.0));
}

const json *row_of(const json &rows, const std::string &rung, int mesh) {
  for (const json &row : rows)
    if (row.value("rung", "") == rung && row.value("mesh", -1) == mesh) return &row;
  return nullptr;
}

KeptError error_of(const StoredStudy &study, const json &row, const json &reference, const std::string &rim) {
  return {.load = study.json["scene"].value("name", study.name),
          .speed = study.approach_speed.value_or(0),
          .deep = {},
          .peak_force = off(row, reference, "peak_force_error"),
          .rebound = off(row, reference, "rebound_error"),
          .depth = {},
          .from = "study " + study.name,
          .same_rim = study.rim_identity == rim};
}

} // namespace

std::vector<KeptError> rung_errors(const std::vector<StoredStudy> &studies, const std::string &rung,
                                   const scene::Bearing &bearing) {
  const std::string rim = scene::rim_identity(bearing);
  const bool between = bearing.double_concave();
  std::vector<KeptError> found;
  for (const StoredStudy &study : studies) {
    if (between && study.rim_identity != rim) continue; // studies of one dish say nothing of two
    const json &rows = study.json.value("rows", json::array());
    for (const int mesh : {2, 1, 0}) {
      const json *own = row_of(rows, rung, mesh), *full = row_of(rows, word(SolvedBy::full), mesh);
      if (!own || !full) continue;
      found.push_back(error_of(study, *own, *full, rim));
      break;
    }
  }
  for (const auto &[name, windows] : kept_windows) {
    const scene::Bearing kept = scene::builtin_bearing(name);
    if (kept.double_concave() != between) continue;
    for (const auto &own : windows)
      for (const auto &full : windows)
        if (word(own.rung) == rung && full.rung == scene::Rung::full && own.rung != full.rung &&
            own.speed == full.speed)
          found.push_back({.load = "window with weight and friction",
                           .speed = own.speed,
                           .deep = own.deep,
                           .peak_force = off(own.peak_force, full.peak_force),
                           .rebound = off(own.rebound, full.rebound),
                           .depth = off(own.deep, full.deep),
                           .from = "kept windows of three rungs",
                           .same_rim = scene::rim_identity(kept) == rim});
  }
  return found;
}

std::vector<KeptError> step_errors(const std::vector<StoredStudy> &studies, const scene::Scene &scene,
                                   const std::string &rim) {
  std::vector<KeptError> found;
  const double step_of_run = scene.model.step > 0 ? scene.model.step : planned_step;
  for (const StoredStudy &study : studies) {
    if (study.rim_identity != rim) continue;
    const json *own = nullptr, *shortest = nullptr;
    double least = 0;
    for (const json &row : study.json["rows"]) {
      if (row.value("rung", "") != word(scene.model.rung) || row.value("mesh", -1) != scene.model.mesh ||
          !row.value("step_s", json()).is_number())
        continue;
      const double asked = row["step_s"].get<double>(), step = asked > 0 ? asked : planned_step;
      if (off(step, step_of_run) < 1e-6) own = &row;
      if (!shortest || step < least) shortest = &row, least = step;
    }
    if (own && shortest && own != shortest) found.push_back(error_of(study, *own, *shortest, rim));
  }
  return found;
}

} // namespace rimpact::calibration

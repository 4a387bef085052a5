/// Runs of a rim that yields, as a calibration reads them, and options that answer fast.
#pragma once
#include "calibration/answer/answer.h"
#include "calibration/answer/calibration_json.h"
#include "laws/impact/catalogue.h"
#include "scene/toml_writer.h"
#include "synthetic.h"
#include <fstream>

namespace rimpact::calibration::testing {

/// A yielding rim; `mass` [kg].
inline scene::Scene yielding(double speed, double mass = 86952) {
  auto s = window(speed, 6e8);
  s.name = fmt::format("yielding-{:g}-{:g}", speed, mass);
  s.load.mass = mass, s.load.vertical = mass * 9.81;
  s.reduced.impact_law = &laws::impact_law("elastoplastic");
  s.reduced.yield_force = 0.9e6;
  s.reduced.hardening = 0.1;
  s.reduced.unloading_gain = 0.3;
  return s;
}

/// A run folder of `truth` whose scene.toml knows nothing of its law, as one of finite elements does.
inline std::string stand_in(const TemporaryFolder &folder, const scene::Scene &truth) {
  const std::string path = folder.write(truth);
  auto told = truth;
  told.reduced = {};
  std::ofstream(path + "/scene.toml") << scene::to_toml(told);
  return path;
}

/// Changes summary.json of a run folder.
inline void amend(const std::string &folder, const nlohmann::json &patch) {
  auto summary = nlohmann::json::parse(std::ifstream(folder + "/summary.json"));
  summary.merge_patch(patch);
  std::ofstream(folder + "/summary.json") << summary.dump(2);
}

inline CalibrationOptions quick(std::vector<std::string> laws) {
  CalibrationOptions options;
  options.laws = std::move(laws);
  options.profiles = false;
  options.grazing_reports = false;
  options.fit.n_starts = 2;
  return options;
}

} // namespace rimpact::calibration::testing

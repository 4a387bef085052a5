/// How far the exported spring is from the law: one mass on both, at five speeds over the exported range.
#pragma once
#include "calibration/export/contact.h"
#include "calibration/export/exported_rim.h"
#include <functional>
#include <memory>

namespace rimpact::calibration {

/// A fresh contact as the target program integrates it; `speed` is that of the touch (read by Hertzdamp).
using MakeContact = std::function<std::unique_ptr<RimContact>(double speed)>;

struct CheckRow {
  double speed; ///< [m/s]
  Bounce law, spring;
};
struct SelfCheck {
  std::string form; ///< whose spring, for messages
  std::vector<CheckRow> rows;
  double peak_force = 0, penetration = 0; ///< largest relative difference [-]
  double rebound = 0;                     ///< largest difference over the approach speed [-]
  bool serves() const { return peak_force <= tolerance && rebound <= tolerance; }
  static constexpr double tolerance = 0.10; ///< on peak force, and on rebound over approach; beyond it the export warns
  std::string sentence() const;
  std::vector<std::string> lines() const; ///< the sentence, and one line a speed
  nlohmann::json json() const;
};
/// `stiffness` [N/m]: the spring's largest.
SelfCheck self_check(const ExportedRim &rim, const std::string &form, const MakeContact &make, double stiffness);

} // namespace rimpact::calibration

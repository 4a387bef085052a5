/// How far the exported spring is from the law, and the exported bearing from the model: one mass on both at five
/// speeds over the exported range, a second time on the dent of the first, and whole flights under pulses
/// (pulse_check.h).
#pragma once
#include "calibration/export/contact.h"
#include "calibration/export/exported_rim.h"
#include "calibration/export/pulse_check.h"

namespace rimpact::calibration {

struct CheckRow {
  double speed; ///< [m/s]
  Bounce law, spring;
  Bounce law_again, spring_again; ///< at the same speed, on the dent of the first; of laws that yield
};
struct SelfCheck {
  std::string form; ///< whose spring, for messages
  std::vector<CheckRow> rows;
  double peak_force = 0, penetration = 0;   ///< largest relative difference [-]
  double rebound = 0;                       ///< largest difference over the approach speed [-]
  bool dents = false;                       ///< the law yields: second hits are flown
  std::string dented_form = {};             ///< what keeps its dent in the file; empty: the form itself
  std::string new_form = {};                ///< what meets a new rim each time; empty: nothing in the file does
  std::optional<PulseCheck> pulses = {};    ///< none: the dish is not known
  nlohmann::json flown_there = {};          ///< what the target program had of such files; null: not tried
  static constexpr double tolerance = 0.10; ///< on peak force, and on rebound over approach; beyond it: a doubt
  bool serves() const { return peak_force <= tolerance && rebound <= tolerance; }
  double again() const;     ///< largest difference in peak force of a second hit [-]
  double again_new() const; ///< the same of a rim that is new each time [-]
};
/// `stiffness` [N/m]: the spring's largest.
SelfCheck self_check(const ExportedRim &rim, const std::string &form, const MakeContact &make, double stiffness);

} // namespace rimpact::calibration

/// How an exported bearing meets its rim under ground motion, against the reduced model: both Ricker pulses of the
/// catalogue at the scales of the main job, 1.00, 1.05 and 1.10. A bearing that these do not bring to its rim gets them
/// at as many times a scale 5 % above that of its first touch. At 1.05 also under a load that varies, as the ground
/// goes up and down beside the pulse.
#pragma once
#include "calibration/export/bearing_flight.h"
#include "calibration/export/exported_model.h"

namespace rimpact::calibration {

struct PulseRow {
  std::string pulse; ///< scene of the catalogue
  double scale;
  Arrival model, exported;
  bool load_varies = false; ///< by check_vertical_g
  std::string name() const; ///< of its motion
  /// Of the peak force, over the model's; over `least_force` where that is larger: a touch that hardly is one.
  double difference(double least_force) const;
};
struct PulseCheck {
  std::vector<PulseRow> rows;
  std::vector<std::string> left_out;        ///< sentences: rows that say nothing, and why
  double least_force = 0;                   ///< of the law at the lowest speed it is exported for [N]
  double slowest = 0;                       ///< that speed [m/s]
  bool written = true;                      ///< false: the file has the rim alone, for what stands here
  static constexpr double tolerance = 0.10; ///< of the peak force; a row beyond it is a doubt with its numbers
  static constexpr double refused = 0.40;   ///< of a row that is judged; beyond it a bearing is not exported
  double worst() const;
  /// Of rows where the model meets its rim no slower than the law knows, or the exported bearing twice as fast as that.
  /// A slower touch moves with anything: the energy left there is some thousandths of the pulse's.
  double worst_judged() const;
  bool refuses() const { return worst_judged() > refused; }
  std::vector<std::string> lines() const;  ///< a sentence of the whole, then one line a row
  std::vector<std::string> doubts() const; ///< of a bearing that is written
  nlohmann::json json() const;
};

PulseCheck pulse_check(const scene::Scene &scene, const ExportedRim &rim, const FlownBearing &bearing);

} // namespace rimpact::calibration

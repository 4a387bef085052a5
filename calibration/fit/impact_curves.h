/// What a law was fitted to, sample by sample, and what the law makes of it: `curves.json` beside calibration.json, for
/// pictures.
///   {"scene": the first run's resolved scene with the law's numbers (TOML), "law": name, "impacts": [{"run", "source",
///    "touch_time_s", "approach_speed_m_s", "fitted", "grazing", "reference": CURVE, "law": CURVE}]}
///   CURVE: {"time_s", "penetration_m", "force_N"}, lists of equal length. Time counts from the reference's touch;
///   penetration is the radial travel beyond L_c; force > 0 pushes inwards. Seven significant digits.
/// An impact is kept from just before touch to just after the later of the two releases.
#pragma once
#include "calibration/fit/fit.h"

namespace rimpact::calibration {

struct Curve {
  std::vector<double> time, penetration, force; ///< [s], [m], [N]
};
struct ImpactCurve {
  std::string run; ///< folder or mapping file
  RunSource source;
  double touch_time, approach_speed; ///< [s] in the run's own time, [m/s]
  bool fitted, grazing;
  Curve reference, law;
};
struct ImpactCurves {
  scene::Scene scene; ///< with the law's numbers
  std::vector<ImpactCurve> impacts;
};

/// Every impact of the runs, fitted and predicted, the law's restarted from the reference's own state.
ImpactCurves impact_curves(const std::vector<StoredRun> &fitted, const std::vector<StoredRun> &predicted,
                           const FitResult &law);

/// Writes `folder`/curves.json. Throws IoError.
void write_curves(const ImpactCurves &curves, const std::string &folder);

} // namespace rimpact::calibration

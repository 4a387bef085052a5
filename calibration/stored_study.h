/// What a run's discretisation error may be: read off the nearest study of speed against error, of those kept with the
/// program (calibration/studies) and those beside the user's results.
#pragma once
#include "scene/scene.h"
#include "scene/summary.h"

namespace rimpact::calibration {

/// A study.json whose `scene` says what was studied.
struct StoredStudy {
  std::string name, bearing;
  std::optional<double> approach_speed; ///< of the first impact [m/s]; empty: no impact
  nlohmann::json json;
};
/// Of the program, then `FOLDER/*/study.json`. What cannot be read is passed over.
std::vector<StoredStudy> stored_studies(const std::string &folder);

/// Absolute errors, the largest of this mesh's and the finer ones':
/// {"peak_force_relative", "rebound_relative", "peak_displacement_relative", "from", "sentence"} of the study of the
/// same bearing, rung and mesh whose impact is nearest in speed (in its logarithm); {"none": why} where there is no such.
nlohmann::json error_estimate(const scene::Scene &scene, const scene::Summary &summary,
                              const std::vector<StoredStudy> &studies);

} // namespace rimpact::calibration

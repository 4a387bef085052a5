/// What a run's discretisation error may be: read off the nearest study of speed against error, of those kept with the
/// program (data/studies) and those beside the user's results.
#pragma once
#include "responses/summary.h"
#include "scene/scene.h"

namespace rimpact::calibration {

/// A study.json whose `scene` says what was studied. Its errors hold for the same solid only, whatever its name.
struct StoredStudy {
  std::string name;
  std::string rim_identity, bearing_identity; ///< see scene/rim_identity.h; empty: a study of before they were kept
  double mass = 0;                            ///< supported [kg]; 0: not known
  std::optional<double> approach_speed;       ///< of the first impact [m/s]; empty: no impact
  nlohmann::json json;
};
/// Of the program, then `FOLDER/*/study.json`. What cannot be read is passed over.
std::vector<StoredStudy> stored_studies(const std::string &folder);
/// What a study keeps of the scene it studied.
nlohmann::json studied_scene(const scene::Scene &scene, const std::optional<double> &approach_speed);

/// The run asked about, for the command that finds what is not known.
struct AskedRun {
  std::string folder; ///< holds its scene.toml; empty: not kept yet
  double seconds = 0; ///< it took [s]; 0: not known
};

/// Absolute errors, the largest of this mesh's and the finer ones':
/// {"peak_force_relative", "rebound_relative", "peak_displacement_relative", "from", "sentence"} of the studies of the
/// same rim (of the whole bearing for rungs that model it), rung and mesh. Between two studies it is linear in the
/// logarithm of the impact's severity v sqrt(m), which is what its penetration goes with; beyond them it is that of the
/// nearest. {"none": why, with the command that finds it} where there is no such.
nlohmann::json error_estimate(const scene::Scene &scene, const Summary &summary,
                              const std::vector<StoredStudy> &studies, const AskedRun &asked = {});

} // namespace rimpact::calibration

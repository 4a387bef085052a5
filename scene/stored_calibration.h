/// A folder that `rimpact calibrate` wrote, read: of its calibration.json the answer, the laws ranked beside it, and
/// which runs were fitted.
#pragma once
#include "scene/stored_answer.h"

namespace rimpact::scene {

/// A law of the ranking, as a row of `laws` keeps it.
struct StoredRankedLaw {
  std::string law = {};
  StoredParameters parameters = {};
  std::optional<double> valid_from = {}, valid_to = {};                  ///< approach [m/s]
  std::optional<double> left_out_peak_force = {}, left_out_rebound = {}; ///< absolute relative [-]
  std::string sentence = {};
  bool operator==(const StoredRankedLaw &) const = default;
};
struct StoredLaws {
  std::optional<double> tolerance = {}; ///< within which a law meets runs left out [-]
  std::vector<StoredRankedLaw> rows = {};
  bool operator==(const StoredLaws &) const = default;
};

struct StoredCalibration {
  std::string file;                        ///< for messages
  std::optional<StoredAnswer> answer = {}; ///< none: an earlier version wrote it
  StoredLaws laws = {};
  std::vector<std::string> fitted_runs = {}; ///< folders
};

nlohmann::json to_json(const StoredRankedLaw &row);

/// Throws DataError naming `file` and the key (read_answer).
StoredCalibration read_calibration(const nlohmann::json &calibration, const std::string &file);
/// FOLDER/calibration.json. Throws DataError also where it cannot be read or is no JSON.
StoredCalibration read_calibration(const std::string &folder);

} // namespace rimpact::scene

#include "scene/stored_calibration.h"

#include "io/files/error.h"
#include "io/files/file.h"
#include <filesystem>

namespace rimpact::scene {

using nlohmann::json;

template <class V> void visit(V &v, StoredRankedLaw &row) {
  v.needed("law", row.law), v("parameters", row.parameters);
  v("valid_from_m_s", row.valid_from), v("valid_to_m_s", row.valid_to);
  v("left_out_peak_force_error", row.left_out_peak_force), v("left_out_rebound_error", row.left_out_rebound);
  v("sentence", row.sentence);
}

template <class V> void visit(V &v, StoredLaws &laws) {
  v("tolerance", laws.tolerance), v("rows", laws.rows);
}

json to_json(const StoredRankedLaw &row) {
  return json_of(row);
}

StoredCalibration read_calibration(const json &calibration, const std::string &file) {
  StoredCalibration read{.file = file};
  const JsonReader whole(calibration, file);
  if (const json *answer = whole.find("answer")) read.answer = read_answer(*answer, file);
  whole("laws", read.laws);
  if (const json *fit = whole.find("fit"))
    for (const auto &[folder, check] : JsonReader(*fit, file, "fit").object().items())
      read.fitted_runs.push_back(folder);
  return read;
}

StoredCalibration read_calibration(const std::string &folder) {
  const std::string file = (std::filesystem::path(folder) / "calibration.json").string();
  const json whole = json::parse(read_file(file), nullptr, false);
  if (whole.is_discarded()) throw DataError(file + ": is not valid JSON");
  return read_calibration(whole, file);
}

} // namespace rimpact::scene

#include "calibration/stored_study.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>

namespace rimpact::calibration {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double near_in_speed = 2; // a study farther off by this factor is said to be far

void add(const fs::path &file, const std::string &name, std::vector<StoredStudy> &studies) {
  std::ifstream text(file);
  const json study = json::parse(text, nullptr, false);
  if (!study.is_object() || !study.contains("scene") || !study.contains("rows")) return;
  try {
    const json &scene = study["scene"];
    StoredStudy stored{name, scene.at("bearing"), {}, study};
    if (scene.at("approach_speed_m_s").is_number()) stored.approach_speed = scene["approach_speed_m_s"].get<double>();
    studies.push_back(stored);
  } catch (const json::exception &) {
    // not one of ours
  }
}

/// The row the others' errors are against; none: the study is not finished.
const json *reference_of(const json &study) {
  for (const json &row : study["rows"])
    if (row.value("reference", false)) return &row;
  return nullptr;
}

/// Whether the study has the rung and mesh with an error that is known: against a finer mesh of that rung, not against another
/// rung, which models more.
bool knows(const StoredStudy &study, const scene::Scene &scene) {
  if (const json *reference = reference_of(study.json); reference && reference->value("rung", "") != scene.model.rung) return false;
  const bool extrapolated = study.json.value("extrapolated_peak_force_N", json()).is_number();
  for (const json &row : study.json["rows"])
    if (row.value("rung", "") == scene.model.rung && row.value("mesh", 0) == scene.model.mesh &&
        (extrapolated || !row.value("reference", true)))
      return true;
  return false;
}

/// Largest of an error over this mesh and the finer ones: where the meshes do not converge from one side, one of them may be
/// right by chance.
json largest(const StoredStudy &study, const scene::Scene &scene, const char *error) {
  json result;
  for (const json &row : study.json["rows"])
    if (row.value("rung", "") == scene.model.rung && row.value("mesh", 0) >= scene.model.mesh && row.value(error, json()).is_number())
      result = std::max(result.is_number() ? result.get<double>() : 0.0, std::abs(row[error].get<double>()));
  return result;
}

std::string against(const json &study) {
  if (study["extrapolated_peak_force_N"].is_number())
    return fmt::format("the limit of three meshes (observed order {:.2g})", study["observed_order"].get<double>());
  if (const json *reference = reference_of(study)) return "its finest run, " + reference->value("name", "");
  return "its finest run";
}

json none(const std::string &why) {
  return {{"none", why}};
}

} // namespace

std::vector<StoredStudy> stored_studies(const std::string &folder) {
  std::vector<StoredStudy> studies;
  std::error_code error;
  for (const auto &file : fs::directory_iterator(RIMPACT_STUDIES, error))
    if (file.path().extension() == ".json") add(file.path(), file.path().stem(), studies);
  for (const auto &beside : fs::directory_iterator(folder, error))
    if (fs::exists(beside.path() / "study.json", error)) add(beside.path() / "study.json", beside.path().filename(), studies);
  std::sort(studies.begin(), studies.end(), [](const auto &a, const auto &b) { return a.name < b.name; });
  return studies;
}

json error_estimate(const scene::Scene &scene, const scene::Summary &summary, const std::vector<StoredStudy> &studies) {
  if (scene.model.own_mesh.any()) return none("no study knows the mesh " + scene.model.own_mesh.file);
  const std::string what = fmt::format("rung {}, mesh {} of bearing {}", scene.model.rung, scene.model.mesh, scene.bearing.name);
  if (summary.impacts.empty()) return none("no study without an impact is kept for " + what + "; rimpact study makes one");
  const double speed = std::max(1e-6, summary.impacts.front().approach_speed);
  const auto distance = [&](const StoredStudy &s) { return std::abs(std::log(*s.approach_speed / speed)); };
  const StoredStudy *nearest = nullptr;
  for (const auto &study : studies)
    if (study.bearing == scene.bearing.name && study.approach_speed.value_or(0) > 0 && knows(study, scene) &&
        (!nearest || distance(study) < distance(*nearest)))
      nearest = &study;
  if (!nearest) return none("no stored study has " + what + "; rimpact study makes one");
  const bool far = distance(*nearest) > std::log(near_in_speed);
  const double error = largest(*nearest, scene, "error");
  return {{"peak_force_relative", error},
          {"rebound_relative", largest(*nearest, scene, "rebound_error")},
          {"peak_displacement_relative", largest(*nearest, scene, "peak_displacement_error")},
          {"from", nearest->name},
          {"study_approach_speed_m_s", *nearest->approach_speed},
          {"sentence", fmt::format("peak force within about {:.1f} % of {}, judged by study {} at {:.3g} m/s{}", 100 * error,
                                   against(nearest->json), nearest->name, *nearest->approach_speed,
                                   far ? fmt::format(" (this impact: {:.3g} m/s, far from it)", speed) : "")}};
}

} // namespace rimpact::calibration

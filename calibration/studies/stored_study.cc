#include "calibration/studies/stored_study.h"
#include "io/files/data_folder.h"
#include "scene/rim_identity.h"
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
/// A level divides sizes by 1.5 and so has 3.4 times the unknowns; kept studies took 6 to 12 times the time from mesh 1
/// to 2.
constexpr double cost_a_level = 6.2;

void add(const fs::path &file, const std::string &name, std::vector<StoredStudy> &studies) {
  std::ifstream text(file);
  const json study = json::parse(text, nullptr, false);
  if (!study.is_object() || !study.contains("scene") || !study.contains("rows")) return;
  try {
    const json &scene = study["scene"];
    StoredStudy stored{
        name, scene.value("rim_identity", ""), scene.value("bearing_identity", ""), scene.value("mass_kg", 0.0), {},
        study};
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

std::optional<scene::Rung> rung_in(const json &row) {
  return parse<scene::Rung>(row.value("rung", ""));
}

/// Whether the study has the rung and mesh with an error that is known: against a finer mesh of that rung, not against
/// another rung, which models more, nor against a shorter step on the same mesh.
bool knows(const StoredStudy &study, const scene::Scene &scene) {
  const bool extrapolated = study.json.value("extrapolated_peak_force_N", json()).is_number();
  if (const json *reference = reference_of(study.json);
      reference &&
      (rung_in(*reference) != scene.model.rung || (!extrapolated && reference->value("mesh", 0) <= scene.model.mesh)))
    return false;
  for (const json &row : study.json["rows"])
    if (rung_in(row) == scene.model.rung && row.value("mesh", 0) == scene.model.mesh &&
        (extrapolated || !row.value("reference", true)))
      return true;
  return false;
}

/// Largest of an error over this mesh and the finer ones: where the meshes do not converge from one side, one of them
/// may be right by chance.
json largest(const StoredStudy &study, const scene::Scene &scene, const char *error) {
  json result;
  for (const json &row : study.json["rows"])
    if (rung_in(row) == scene.model.rung && row.value("mesh", 0) >= scene.model.mesh &&
        row.value(error, json()).is_number())
      result = std::max(result.is_number() ? result.get<double>() : 0.0, std::abs(row[error].get<double>()));
  return result;
}

std::string against(const json &study) {
  if (study["extrapolated_peak_force_N"].is_number())
    return fmt::format("the limit of three meshes (observed order {:.2g})", study["observed_order"].get<double>());
  if (const json *reference = reference_of(study)) return "its finest run, " + reference->value("name", "");
  return "its finest run";
}

/// Whether it studied what the scene is: the rim, and with a rung that models the dish all of the bearing.
bool same_solid(const StoredStudy &study, const scene::Scene &scene) {
  if (!has_dish(scene.model.rung)) return study.rim_identity == scene::rim_identity(scene.bearing);
  return study.bearing_identity == scene::bearing_identity(scene.bearing);
}

/// The command that makes the study, to be found beside the run, and what it costs [min]; 0: not known.
std::pair<std::string, double> command(const scene::Scene &scene, const AskedRun &asked) {
  const int coarsest = std::min(scene.model.mesh, 1);
  const fs::path folder = fs::path(asked.folder).lexically_normal(),
                 name = folder.has_filename() ? folder.filename() : folder.parent_path().filename();
  std::string text = fmt::format("rimpact study {} --axes mesh --meshes {},{},{}",
                                 asked.folder.empty() ? "SCENE" : (folder / "scene.toml").string(), coarsest,
                                 coarsest + 1, coarsest + 2);
  if (!asked.folder.empty())
    text += fmt::format(" -o {}", (folder / ".." / ("study-" + name.string())).lexically_normal().string());
  double seconds = 0;
  for (int mesh = coarsest; mesh < coarsest + 3; ++mesh)
    seconds += asked.seconds * std::pow(cost_a_level, mesh - scene.model.mesh);
  return {text, seconds / 60};
}

/// No stored study has `what`.
json to_be_studied(const std::string &what, const scene::Scene &scene, const AskedRun &asked) {
  const auto [typed, minutes] = command(scene, asked);
  const std::string cost = minutes > 0 ? fmt::format(" (about {:.0f} min)", std::max(1.0, minutes)) : "";
  return {{"none", fmt::format("unknown: no stored study has {}. This command finds it: {}{}", what, typed, cost)},
          {"command", typed},
          {"minutes", minutes}};
}

json none(const std::string &why) {
  return {{"none", why}};
}

/// A figure of one study or between two.
json between(const StoredStudy &low, const StoredStudy &high, double share, const scene::Scene &scene,
             const char *error) {
  const json a = largest(low, scene, error), b = largest(high, scene, error);
  if (!a.is_number() || !b.is_number()) return json();
  return (1 - share) * a.get<double>() + share * b.get<double>();
}

} // namespace

std::vector<StoredStudy> stored_studies(const std::string &folder) {
  std::vector<StoredStudy> studies;
  std::error_code error;
  for (const auto &file : fs::directory_iterator(fs::path(data_folder()) / "data" / "studies", error))
    if (file.path().extension() == ".json") add(file.path(), file.path().stem(), studies);
  for (const auto &beside : fs::directory_iterator(folder, error))
    if (fs::exists(beside.path() / "study.json", error))
      add(beside.path() / "study.json", beside.path().filename(), studies);
  std::sort(studies.begin(), studies.end(), [](const auto &a, const auto &b) { return a.name < b.name; });
  return studies;
}

json studied_scene(const scene::Scene &scene, const std::optional<double> &approach_speed) {
  return {{"name", scene.name},
          {"bearing", scene.bearing.name},
          {"rim_identity", scene::rim_identity(scene.bearing)},
          {"bearing_identity", scene::bearing_identity(scene.bearing)},
          {"mass_kg", scene.load.mass},
          {"approach_speed_m_s", approach_speed ? json(*approach_speed) : json()}};
}

json error_estimate(const scene::Scene &scene, const Summary &summary, const std::vector<StoredStudy> &studies,
                    const AskedRun &asked) {
  if (scene.model.own_mesh.any()) return none("unknown: no study knows the mesh " + scene.model.own_mesh.file);
  const std::string what = fmt::format("rung {}, mesh {} of this bearing", word(scene.model.rung), scene.model.mesh);
  if (summary.impacts.empty()) return none("unknown: no study without an impact is kept for " + what);
  const double speed = std::max(1e-6, summary.impacts.front().approach_speed);
  // speed of an impact of the run's mass that is as severe
  const auto equivalent = [&](const StoredStudy &s) {
    return *s.approach_speed * (s.mass > 0 ? std::sqrt(s.mass / scene.load.mass) : 1);
  };
  const auto distance = [&](const StoredStudy &s) { return std::log(equivalent(s) / speed); };
  const StoredStudy *low = nullptr, *high = nullptr;
  for (const auto &study : studies) {
    if (!(study.approach_speed.value_or(0) > 0) || !same_solid(study, scene) || !knows(study, scene)) continue;
    if (distance(study) <= 0 && (!low || distance(study) > distance(*low))) low = &study;
    if (distance(study) >= 0 && (!high || distance(study) < distance(*high))) high = &study;
  }
  if (!low && !high) return to_be_studied(what, scene, asked);
  if (!low) low = high;
  if (!high) high = low;
  const double width = distance(*high) - distance(*low), share = width > 0 ? -distance(*low) / width : 0;
  const json error = between(*low, *high, share, scene, "error");
  const bool far = low == high && std::abs(distance(*low)) > std::log(near_in_speed);
  const auto one = [&](const StoredStudy &s) {
    return fmt::format("study {} at {:.3g} m/s", s.name, *s.approach_speed);
  };
  const auto judged =
      low == high ? one(*low)
                  : fmt::format("{} and {}, this impact of {:.3g} m/s between them", one(*low), one(*high), speed);
  json estimate{{"peak_force_relative", error},
                {"rebound_relative", between(*low, *high, share, scene, "rebound_error")},
                {"peak_displacement_relative", between(*low, *high, share, scene, "peak_displacement_error")},
                {"from", low == high ? low->name : low->name + " and " + high->name},
                {"far", far}};
  if (low == high) estimate["study_approach_speed_m_s"] = *low->approach_speed;
  estimate["sentence"] =
      fmt::format("peak force within about {:.1f} % of {}, judged by {}{}", 100 * error.get<double>(),
                  against(low->json), judged, far ? fmt::format(" (this impact: {:.3g} m/s, far from it)", speed) : "");
  return estimate;
}

} // namespace rimpact::calibration

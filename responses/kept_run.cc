#include "responses/kept_run.h"

#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/text.h"
#include "scene/toml_writer.h"
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <regex>

namespace rimpact {
namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path &path) {
  std::error_code none;
  return fs::exists(path, none);
}

/// Keys of summary.json and what they hold; all may be absent or null, but for the status.
enum class Is { number, text, list, object };
constexpr std::array<std::pair<const char *, Is>, 20> known{{{"status", Is::text},
                                                             {"reason", Is::text},
                                                             {"rung", Is::text},
                                                             {"mesh", Is::number},
                                                             {"impacts", Is::list},
                                                             {"n_impacts", Is::number},
                                                             {"peak_displacement_m", Is::number},
                                                             {"peak_lateral_force_N", Is::number},
                                                             {"peak_impact_force_N", Is::number},
                                                             {"residual_displacement_m", Is::number},
                                                             {"final_speed_m_s", Is::number},
                                                             {"max_plastic_strain", Is::number},
                                                             {"min_normal_force_N", Is::number},
                                                             {"wall_time_s", Is::number},
                                                             {"peak_memory_bytes", Is::number},
                                                             {"n_dofs", Is::number},
                                                             {"n_steps", Is::number},
                                                             {"energy", Is::object},
                                                             {"warnings", Is::list},
                                                             {"time_split_s", Is::object}}};

bool fits(const nlohmann::json &value, Is kind) {
  switch (kind) {
  case Is::number:
    return value.is_number();
  case Is::text:
    return value.is_string();
  case Is::list:
    return value.is_array();
  case Is::object:
    return value.is_object();
  }
  return false;
}

const char *name_of(Is kind) {
  constexpr std::array names{"a number", "a text", "a list", "an object"};
  return names[static_cast<std::size_t>(kind)];
}

void check_impacts(const nlohmann::json &summary, const std::string &path) {
  if (!summary.contains("impacts") || summary["impacts"].is_null()) return;
  for (const auto &impact : summary["impacts"]) {
    if (!impact.is_object()) throw DataError(fmt::format("{} is damaged: an entry of `impacts` is no object", path));
    for (const auto &[key, value] : impact.items())
      if (!value.is_number() && !value.is_null())
        throw DataError(
            fmt::format("{} is damaged: `{}` of an impact must be a number, got {}", path, key,
                        value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).substr(0, 40)));
  }
}

/// What to_toml would write of the kept scene today; its own text where it cannot be read any more (a record is gone).
std::string kept_scene(const std::string &path) {
  const std::string text = read_file(path);
  try {
    return scene::to_toml(scene::parse_scene(text, path, {}, fs::path(path).parent_path().string()));
  } catch (const Error &) {
    return text;
  }
}

void take_away(const fs::path &path) {
  std::error_code error;
  fs::remove_all(path, error);
  if (error) throw IoError(fmt::format("cannot remove the earlier result {}: {}", path.string(), error.message()));
}

} // namespace

nlohmann::json read_summary(const std::string &folder) {
  const std::string path = (fs::path(folder) / "summary.json").string();
  if (!is_there(path)) return nlohmann::json::object();
  auto summary = nlohmann::json::parse(read_file(path), nullptr, false);
  if (!summary.is_object()) throw DataError(path + " is damaged: it is not a JSON object");
  for (const auto &[key, kind] : known) {
    const auto found = summary.find(key);
    if (found == summary.end() || (found->is_null() && std::string_view(key) != "status") || fits(*found, kind))
      continue;
    const auto got = found->dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).substr(0, 40);
    throw DataError(fmt::format("{} is damaged: `{}` must be {}, got {}", path, key, name_of(kind), got));
  }
  check_impacts(summary, path);
  return summary;
}

std::string text_in(const nlohmann::json &summary, const char *key, const std::string &folder) {
  if (!summary[key].is_string())
    throw DataError(
        fmt::format("{}/summary.json: {} is {}, not a word; was the file changed?", folder, key, summary[key].dump()));
  return summary[key];
}

void refuse_word(const std::string &word, const std::vector<std::string> &known, const char *key,
                 const std::string &folder) {
  throw DataError(fmt::format("{}/summary.json: {} {}", folder, key, unknown_word(word, known)));
}

KeptRun kept_run(const std::string &folder, const scene::Scene &scene, const std::string &program) {
  const fs::path in = folder;
  KeptRun kept;
  kept.any = is_there(in / "summary.json") || is_there(in / "response.h5") || is_there(in / "checkpoint.h5");
  if (!kept.any) return kept;
  nlohmann::json summary;
  try {
    summary = read_summary(folder);
  } catch (const DataError &) {
    kept.changed = "its summary.json is damaged";
    return kept;
  }
  kept.status = parse<RunStatus>(summary.value("status", ""));
  const SolvedBy unsaid = is_there(in / "checkpoint.h5") ? SolvedBy::rim : SolvedBy::reduced;
  kept.finite_elements = parse<SolvedBy>(summary.value("rung", word(unsaid))) != SolvedBy::reduced;
  const std::string here = scene::to_toml(scene), scene_file = (in / "scene.toml").string();
  if (is_there(scene_file) && read_file(scene_file) != here)
    kept.other_scene = scene_differences(kept_scene(scene_file), here);
  kept.other_name = kept.other_scene.starts_with("name is ");
  const auto identity = identity_from(summary.value("identity", nlohmann::json()));
  kept.same_program = identity && identity->build == program;
  kept.killed = is_there(in / "checkpoint.h5") && !is_there(in / "summary.json");
  if (!is_there(in / "summary.json"))
    kept.changed = "it was not finished";
  else if (!identity)
    kept.changed = "it was made by an older version, which did not note the files it read";
  else if (kept.other_scene.empty()) { // the words above say what else
    Identity now = identity_of(scene);
    now.build = program;
    if (const auto what = changes(*identity, now); !what.empty()) kept.changed = what + " since";
  }
  return kept;
}

std::optional<Collection> collection_in(const std::string &folder) {
  for (const auto &[file, what] : {std::pair{"fleet.json", Collection::sweep},
                                   {"main.json", Collection::main_job},
                                   {"study.json", Collection::study},
                                   {"geometry.json", Collection::geometry_study}})
    if (is_there(fs::path(folder) / file)) return what;
  return {};
}

void remove_unfinished(const std::string &folder) {
  static const std::regex ours(R"(\.(scene\.toml|summary\.json|response\.(h5|csv)|checkpoint\.h5)\.[0-9]+\.tmp)");
  std::error_code none;
  std::vector<fs::path> unfinished;
  for (const auto &entry : fs::directory_iterator(folder, none))
    if (std::regex_match(entry.path().filename().string(), ours)) unfinished.push_back(entry.path());
  for (const auto &file : unfinished) take_away(file);
}

void remove_by_products(const std::string &folder) {
  remove_unfinished(folder);
  for (const char *name : {"checkpoint.h5", "fields", "fields.pvd", "response.png", "report.html", "report.pdf",
                           "log.txt", "film.html", "film.mp4", "building.csv", "storeys.csv", "paraview_state.py"})
    take_away(fs::path(folder) / name);
}

void remove_run(const std::string &folder) {
  for (const char *name : {"summary.json", "response.h5", "response.csv"}) take_away(fs::path(folder) / name);
  remove_by_products(folder);
}

} // namespace rimpact

#include "responses/run_folder.h"

#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/json_text.h"
#include "responses/git_hash.h"
#include "responses/identity.h"
#include "responses/open_impact.h"
#include "responses/response_csv.h"
#include "responses/response_hdf5.h"
#include "scene/toml_writer.h"
#include <filesystem>

namespace rimpact {
namespace {

/// What it is a run of, beside what came out. A long run has noted its identity when it began and read its files; a
/// short one has just read them. A file that is gone since must not cost the result, which then counts as one without
/// an identity.
nlohmann::json of_scene(nlohmann::json summary, const scene::Scene &scene) {
  summary["lateral_capacity_m"] = scene.lateral_capacity();
  if (summary.contains("identity")) return summary;
  try {
    summary["identity"] = to_json(identity_of(scene));
  } catch (const DataError &) {
    summary["identity"] = nullptr;
  }
  return summary;
}

} // namespace

void write_run_folder(const std::string &folder, const scene::Scene &scene, Response response, const Summary &given) {
  namespace fs = std::filesystem;
  make_folder(folder);
  const auto in = [&](const char *name) { return (fs::path(folder) / name).string(); };
  Summary summary = given;
  if (summary.status != RunStatus::done || doubt_of_rebound(response, summary.impacts))
    leave_last_impact_open(response, summary);
  const std::string toml = to_toml(scene), json = json_text(of_scene(to_json(summary), scene));
  response.series("time"); // a run stopped before its first sample still leaves a readable file
  response.meta["version"] = RIMPACT_VERSION;
  response.meta["git"] = RIMPACT_GIT_HASH;
  response.meta["scene"] = toml;
  response.meta["summary"] = json;
  write_atomically(toml, in("scene.toml"));
  write_hdf5(response, in("response.h5"));
  write_csv(response, in("response.csv"));
  write_atomically(json, in("summary.json")); // last: its presence says that the run folder is complete
}

} // namespace rimpact

#include "scene/error.h"
#include "scene/files.h"
#include "scene/git_hash.h"
#include "scene/summary.h"
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

/// Bytes of a reason that are not UTF-8 (file names may be anything) must not stop the writing of results.
std::string dump(const nlohmann::json &json) {
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

} // namespace

void write_run_folder(const std::string &folder, const Scene &scene, Response response,
                      const Summary &summary) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw IoError(fmt::format("cannot create the folder {}: {}", folder, error.message()));
  const auto in = [&](const char *name) { return (fs::path(folder) / name).string(); };
  const std::string toml = to_toml(scene), json = dump(to_json(summary));
  response.series("time"); // a run stopped before its first sample still leaves a readable file
  response.meta["version"] = RIMPACT_VERSION;
  response.meta["git"] = RIMPACT_GIT_HASH;
  response.meta["scene"] = toml;
  response.meta["summary"] = json;
  write_text(toml, in("scene.toml"));
  write_hdf5(response, in("response.h5"));
  write_csv(response, in("response.csv"));
  write_text(json, in("summary.json")); // last: its presence says that the run folder is complete
}

} // namespace rimpact::scene

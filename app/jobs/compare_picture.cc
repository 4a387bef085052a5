#include "app/jobs/compare_picture.h"
#include "app/console/child_process.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/json_text.h"
#include "responses/build_version.h"
#include "responses/response_hdf5.h"
#include <filesystem>

namespace rimpact::app {

std::string draw_comparison(const std::string &folder, const std::vector<ComparedCurve> &curves, double capacity) {
  namespace fs = std::filesystem;
  nlohmann::json items = nlohmann::json::array();
  for (const auto &curve : curves) {
    const fs::path place = fs::path(folder) / "curves" / curve.name;
    make_folder(place.string());
    write_hdf5(*curve.response, (place / "response.h5").string());
    if (!curve.scene.empty()) write_atomically(curve.scene, (place / "scene.toml").string());
    items.push_back(curve.said);
    items.back()["name"] = curve.name;
  }
  const nlohmann::json all{{"version", build_version()}, {"capacity_m", capacity}, {"items", items}};
  write_atomically(json_text(all), (fs::path(folder) / "compare.json").string());
  if (python({"report.compare", folder}) != 0) throw IoError("the pictures in " + folder + " were not made");
  return (fs::path(folder) / "compare.html").string();
}

} // namespace rimpact::app

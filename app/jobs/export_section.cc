#include "app/jobs/export_section.h"
#include "app/jobs/given_case.h"
#include "calibration/export/section_dxf.h"
#include "io/files/file.h"
#include "io/files/json_text.h"

namespace rimpact::app {

void export_section(const ExportOptions &options, const std::vector<std::string> &head, Console &console) {
  if (options.asks_a_calibration() || options.opensees)
    throw InputError("export " + options.folder +
                     ": no calibration.json in it; a bearing without one has its section only: --dxf");
  const GivenCase given = given_case(options.folder, {});
  if (given.scene.rigid_bodies() && !given.scene.bearing.double_concave())
    throw InputError("export --dxf: " + given.origin + " has reduced.model \"" + word(given.scene.reduced.model) +
                     "\"; the section of one dish, or of two, is what is drawn");
  const std::string folder = options.out.empty() ? default_folder(given.scene.bearing.name) + "-drawn" : options.out;
  const std::string path = folder + "/section.dxf";
  make_folder(folder);
  write_atomically(calibration::section_dxf(given.scene.bearing, head), path);
  console.data(console.json ? json_text(nlohmann::ordered_json{{"files", {path}}}) : path + "\n");
}

} // namespace rimpact::app

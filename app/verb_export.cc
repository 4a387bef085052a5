// rimpact export DIR --opensees: calibrated parameters as Tcl and Python.
#include "app/verb.h"
#include "calibration/opensees.h"
#include "scene/response.h"
#include <fmt/format.h>
#include <fstream>

namespace rimpact::app {
namespace {

nlohmann::json read_calibration(const std::string &folder) {
  for (const std::string &path : {folder + "/calibration.json", folder + "/calibration/calibration.json"}) {
    std::ifstream file(path);
    if (!file) continue;
    auto json = nlohmann::json::parse(file, nullptr, false);
    if (json.is_discarded()) throw DataError(path + ": not valid JSON");
    return json;
  }
  throw DataError(folder + ": no calibration.json in it; run `rimpact calibrate` first");
}

} // namespace

void add_export(CLI::App &app, Console &console) {
  auto folder = std::make_shared<std::string>();
  auto springs = std::make_shared<int>(2);
  auto *verb = app.add_subcommand("export", "calibrated parameters for other programs");
  verb->add_option("DIR", *folder, "folder of a calibration")->required();
  verb->add_flag("--opensees")->description("Tcl and Python")->required();
  verb->add_option("--springs", *springs, "gap springs around the slider, 4 or more; 2: along x")->capture_default_str();
  console.add_common(*verb);
  verb->callback([folder, springs, &console] {
    try {
      const auto rim = calibration::rim_springs(read_calibration(*folder));
      scene::write_text(calibration::opensees_tcl(rim, *springs), *folder + "/impact.tcl");
      scene::write_text(calibration::opensees_python(rim, *springs), *folder + "/impact.py");
    } catch (const DataError &error) {
      throw DataError(*folder + ": " + error.what());
    }
    console.data(*folder + "/impact.tcl\n" + *folder + "/impact.py\n");
  });
}

} // namespace rimpact::app

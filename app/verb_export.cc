// rimpact export DIR --opensees: calibrated parameters as Tcl and Python.
#include "app/verb.h"
#include "scene/response.h"
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

namespace rimpact::app {
namespace {

nlohmann::json read_calibration(const std::string &folder) {
  for (const std::string &path : {folder + "/calibration.json", folder + "/calibration/calibration.json"}) {
    std::ifstream file(path);
    if (!file) continue;
    const auto json = nlohmann::json::parse(file, nullptr, false);
    if (json.is_discarded()) throw DataError(path + ": not valid JSON");
    return json;
  }
  throw DataError(folder + ": no calibration.json in it; run `rimpact calibrate` first");
}

} // namespace

void add_export(CLI::App &app, Console &console) {
  auto folder = std::make_shared<std::string>();
  auto opensees = std::make_shared<bool>(false);
  auto *verb = app.add_subcommand("export", "calibrated parameters for other programs");
  verb->add_option("DIR", *folder, "folder of a calibration")->required();
  verb->add_flag("--opensees", *opensees, "Tcl and Python")->required();
  console.add_common(*verb);
  verb->callback([folder, &console] {
    const auto json = read_calibration(*folder);
    if (!json.contains("parameters") || !json["parameters"].contains("k_i") ||
        !json["parameters"].contains("e"))
      throw DataError(*folder + ": the calibration holds no k_i and e");
    const double k_i = 1e3 * json["parameters"]["k_i"]["value"].get<double>(),
                 e = json["parameters"]["e"]["value"];
    std::string note =
        "impact law, damping and mass: " + json.value("derived", nlohmann::json::object()).dump();
    const auto lines = [&](const char *assign) {
      return fmt::format("# rim impact fitted by rimpact; SI units (N, m, s). {}\n", note) +
             fmt::format(fmt::runtime(assign), "k_i", k_i) +
             fmt::format(fmt::runtime(assign), "restitution", e);
    };
    scene::write_text(lines("set {} {:.8g}\n"), *folder + "/impact.tcl");
    scene::write_text(lines("{} = {:.8g}\n"), *folder + "/impact.py");
    console.data(*folder + "/impact.tcl\n" + *folder + "/impact.py\n");
  });
}

} // namespace rimpact::app

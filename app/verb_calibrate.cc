// rimpact calibrate RUN...: k_i, e and others fitted to stored responses.
#include "app/verb.h"
#include "calibration/calibration_json.h"
#include <fmt/format.h>
#include <sstream>

namespace rimpact::app {

void add_calibrate(CLI::App &app, Console &console) {
  struct Options {
    std::vector<std::string> runs, predict;
    std::string folder = "results/calibration", fit = "k_i,e";
  };
  auto *verb = app.add_subcommand("calibrate", "fit impact parameters to stored responses");
  auto options = std::make_shared<Options>();
  verb->add_option("RUN", options->runs, "run folders to fit")->required();
  verb->add_option("-o,--output", options->folder, "folder for calibration.json");
  verb->add_option("--fit", options->fit, "parameters, e.g. k_i,e");
  verb->add_option("--predict", options->predict, "run folders to predict, not to fit");
  console.add_common(*verb);
  console.add_json(*verb);
  verb->callback([options, &console] {
    calibration::CalibrationOptions settings;
    settings.predict = options->predict;
    settings.fit.parameters.clear();
    std::stringstream names(options->fit);
    for (std::string name; std::getline(names, name, ',');) settings.fit.parameters.push_back(name);
    const auto calibration = calibration::calibrate(options->runs, settings);
    calibration::write_calibration(calibration, options->folder);
    console.data(console.json ? calibration::to_json(calibration).dump(2) + "\n"
                              : calibration::describe(calibration));
    console.message(options->folder + "/calibration.json");
    calibration::check_gate(calibration);
  });
}

} // namespace rimpact::app

// rimpact calibrate RUN...: k_i, e and others fitted to stored responses.
#include "app/verbs/calibrate_options.h"
#include "calibration/answer/calibration_json.h"
#include "calibration/answer/calibration_text.h"
#include "io/files/folder_lock.h"
#include "io/files/json_text.h"
#include <chrono>
#include <fmt/format.h>

namespace rimpact::app {
namespace {
constexpr double worth_telling = 5; // [s]
void add_calibrate(CLI::App &verb, Console &console) {
  struct CalibrateOptions {
    std::vector<std::string> runs;
    std::string folder = "results/calibration";
    CalibrateWords words;
  };
  auto options = std::make_shared<CalibrateOptions>();
  verb.add_option("RUN", options->runs, "run folders to fit")->required();
  verb.add_option("-o,--output", options->folder, "folder for calibration.json");
  add_calibrate_options(verb, options->words);
  console.add_common(verb);
  console.add_json(verb);
  verb.callback([options, &console] {
    const FolderLock lock(options->folder);
    const auto settings = calibrate_settings(options->words);
    const auto start = std::chrono::steady_clock::now();
    const auto calibration = calibration::calibrate(options->runs, settings);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (seconds > worth_telling && !settings.laws.empty())
      console.message(
          fmt::format("fits of {} laws and of each without one run at a time: {:.0f} s; --laws none does without",
                      settings.laws.size(), seconds));
    calibration::write_calibration(calibration, options->folder);
    console.data(console.json ? json_text(calibration::to_json(calibration)) : calibration::describe(calibration));
    console.message(options->folder + "/calibration.json");
    calibration::check_gate(calibration);
  });
}

} // namespace

const Verb calibrate_verb{{.name = "calibrate",
                           .help = "fit impact parameters to stored responses",
                           .examples = "rimpact calibrate runs/window-*/ -o my-calibration\n"
                                       "rimpact calibrate test-07.toml --law elastoplastic --sigma force=0.02",
                           .next = "rimpact reduced SCENE --calibration {}",
                           .usual = "results/calibration"},
                          add_calibrate};

} // namespace rimpact::app

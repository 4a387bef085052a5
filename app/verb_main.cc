// rimpact main: from a bearing to calibrated k_i and e, with a report.
#include "app/main_results.h"
#include "app/progress.h"
#include "app/sibling.h"
#include "app/verb.h"
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::app {

void add_main(CLI::App &app, Console &console) {
  struct Options {
    std::string bearing = "shfps-225", folder = "results/main";
  };
  auto *verb = app.add_subcommand("main", "the main job: rim impacts by FE, calibration, comparison, report");
  auto options = std::make_shared<Options>();
  verb->add_option("BEARING", options->bearing, "a TOML file or a built-in bearing");
  verb->add_option("-o,--output", options->folder, "results folder");
  console.add_common(*verb);
  verb->callback([options, &console] {
    const auto begin = std::chrono::steady_clock::now();
    const auto bearing = scene::load_bearing(options->bearing);
    bearing.validate();
    std::error_code error;
    std::filesystem::create_directories(options->folder, error);
    if (error) throw IoError("cannot make " + options->folder + ": " + error.message());
    auto jobs = main_jobs(bearing, options->folder);
    run_jobs(jobs, console);
    const auto spent = [&] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    const std::string table = make_results(jobs, options->folder, spent(), console);
    const int code = python({"report", options->folder});
    console.data(table);
    if (code != 0) throw IoError("the report was not written; try rimpact report " + options->folder);
    console.data(fmt::format("report: {}/report.html  ({} in all)\n", options->folder, duration(spent())));
    for (const auto &job : jobs)
      if (!job.done) throw SolverStopped("not every run ended well; the report says which");
  });
}

} // namespace rimpact::app

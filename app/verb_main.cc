// rimpact main: from a bearing to calibrated k_i and e, with a report.
#include "app/calibrate_options.h"
#include "app/job_runner.h"
#include "app/main_results.h"
#include "app/sibling.h"
#include "app/verb.h"
#include <fmt/format.h>

namespace rimpact::app {
namespace {

struct Options {
  std::string bearing = "shfps-225", folder = "results/main", laws = "signed,no-tension,elastoplastic";
};

void run_main(const Options &options, Console &console) {
  const auto begin = std::chrono::steady_clock::now();
  const auto spent = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  const auto laws = laws_named(options.laws);
  auto jobs = main_jobs(scene::load_bearing(options.bearing), options.folder);
  JobRunner runner(jobs, console);
  make_runs_folder(options.folder);
  const auto versions = fe_versions(options.folder, console);

  watch_interrupts();
  runner.run();
  MainResults results = make_results(jobs, options.folder, versions, spent(), laws, console);
  const int code = python({"report", options.folder});
  const std::string report = options.folder + "/report.html";
  results.main["report"] = code == 0 ? nlohmann::json(report) : nlohmann::json();
  console.data(console.json ? results.main.dump(2) + "\n" : results.text);
  if (interrupted())
    throw Error(ExitCode::interrupted, "interrupted; the same command goes on where it stopped");
  if (code != 0) throw IoError("the report was not written; try rimpact report " + options.folder);
  if (!console.json) console.data(fmt::format("report: {}  ({} in all)\n", report, duration(spent())));
  require_done(jobs);
  if (results.failure) std::rethrow_exception(results.failure);
}

} // namespace

void add_main(CLI::App &app, Console &console) {
  auto *verb = app.add_subcommand("main", "the main job: rim impacts by FE, calibration, comparison, report");
  auto options = std::make_shared<Options>();
  verb->add_option("BEARING", options->bearing, "a TOML file or a built-in bearing");
  verb->add_option("-o,--output", options->folder, "results folder");
  verb->add_option("--laws", options->laws, "impact laws to rank in the report: all, none or names")
      ->capture_default_str();
  console.add_common(*verb);
  console.add_json(*verb);
  verb->callback([options, &console] { run_main(*options, console); });
}

} // namespace rimpact::app

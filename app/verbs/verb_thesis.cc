// rimpact thesis: a figure or table of the thesis by its number, made by this program's own verbs and drawn beside it.
#include "app/console/child_process.h"
#include "app/verbs/catalogue.h"
#include <fmt/format.h>

namespace rimpact::app {
namespace {

struct ThesisOptions {
  std::string what = "list", records, calibration, folder = "results/thesis";
  int jobs = 0; ///< side by side; 0: as many as there are cores
  bool cheap = false;
};

std::vector<std::string> command(const ThesisOptions &options, const Console &console) {
  std::vector<std::string> words{"report.thesis", "--program=" + program_beside("rimpact"),
                                 "--output=" + options.folder};
  if (!options.records.empty()) words.push_back("--records=" + options.records);
  if (!options.calibration.empty()) words.push_back("--calibration=" + options.calibration);
  if (options.jobs > 0) words.push_back(fmt::format("--jobs={}", options.jobs));
  if (options.cheap) words.emplace_back("--cheap");
  if (console.json) words.emplace_back("--json");
  if (console.quiet) words.emplace_back("--quiet");
  words.insert(words.end(), {"--", options.what});
  return words;
}

void run_thesis(const ThesisOptions &options, Console &console) {
  const int code = python(command(options, console), true);
  if (code == static_cast<int>(ExitCode::input)) throw InputError("thesis " + options.what + ": nothing was made");
  if (code == static_cast<int>(ExitCode::data)) throw DataError("thesis " + options.what + ": nothing could be made");
  if (code != 0) throw IoError("thesis " + options.what + " was not finished");
}

void add_thesis(CLI::App &verb, Console &console) {
  auto options = std::make_shared<ThesisOptions>();
  verb.add_option("WHAT", options->what, "list, headlines, fig-2-7, table-3-4, design, ... or all")
      ->capture_default_str();
  verb.add_flag("--cheap", options->cheap, "only what takes seconds: no finite elements");
  verb.add_option("--jobs", options->jobs, "runs side by side (default: one a core)")->check(CLI::Range(1, 64));
  verb.add_option("--records", options->records, "folder of your AT2 files (default: RIMPACT_RECORDS, else this one)");
  verb.add_option("--calibration", options->calibration,
                  "of bearings of two dishes: a law of their rims instead of the one assumed, beside which it stands")
      ->type_name("DIR");
  verb.add_option("-o,--output", options->folder, "folder of runs, pictures and pages")->capture_default_str();
  console.add_common(verb);
  console.add_json(verb);
  verb.callback([options, &console] { run_thesis(*options, console); });
}

} // namespace

const Verb thesis_verb{{.name = "thesis",
                        .help = "a figure or table of the thesis by its number, ours drawn over it",
                        .examples = "rimpact thesis list\nrimpact thesis headlines\nrimpact thesis fig-2-7"},
                       add_thesis};

} // namespace rimpact::app

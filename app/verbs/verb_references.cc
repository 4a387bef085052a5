// rimpact references: the finite-element references that are kept with the program, made again and held against what is
// kept.
#include "app/console/child_process.h"
#include "app/verbs/catalogue.h"

namespace rimpact::app {
namespace {

struct ReferencesOptions {
  std::vector<std::string> names;
  std::string folder = "results/references";
  bool list = false;
};

void run_references(const ReferencesOptions &options, Console &console) {
  std::vector<std::string> words{"report.references", "--program=" + program_beside("rimpact"),
                                 "--output=" + options.folder};
  if (options.list) words.emplace_back("--list");
  if (console.json) words.emplace_back("--json");
  if (console.quiet) words.emplace_back("--quiet");
  words.emplace_back("--");
  words.insert(words.end(), options.names.begin(), options.names.end());
  if (!options.list) static_cast<void>(fe_program()); // says so where it was not built
  const int code = python(words, true);
  if (code == static_cast<int>(ExitCode::input)) throw InputError("references: nothing was made");
  if (code == static_cast<int>(ExitCode::data)) throw DataError("references: not all could be compared");
  if (code == static_cast<int>(ExitCode::stopped)) throw SolverStopped("references: not every run came to its end");
  if (code != 0) throw IoError("the references were not finished");
}

void add_references(CLI::App &verb, Console &console) {
  auto options = std::make_shared<ReferencesOptions>();
  verb.add_option("NAME", options->names, "window-0.20, pulse-0.78g-1.05, ...; all without a name");
  verb.add_flag("--list", options->list, "what is kept and what it cost; makes nothing");
  verb.add_option("-o,--output", options->folder,
                  "folder of their run folders and references.json; an interrupted job goes on there")
      ->capture_default_str();
  console.add_common(verb);
  console.add_json(verb);
  verb.callback([options, &console] { run_references(*options, console); });
}

} // namespace

const Verb references_verb{
    {.name = "references",
     .help = "the kept finite-element references, made again: cost, and what moved",
     .examples = "rimpact references --list\nrimpact references window-0.20 pulse-0.78g-1.05 -o again",
     .next = "rimpact calibrate {}/window-*",
     .usual = "results/references"},
    add_references};

} // namespace rimpact::app

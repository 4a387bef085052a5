// rimpact report DIR: one self-contained HTML file whose first page can be sent, and a PDF of it.
#include "app/console/child_process.h"
#include "app/verbs/catalogue.h"
#include "calibration/data/measured_name.h"
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

struct ReportOptions {
  std::string folder, output, document;
  std::map<std::string, std::string> head; ///< title, client, project, author: what is given
  std::string language;                    ///< of the client's two pages; empty: the report itself
  bool pdf = false;
};

std::vector<std::string> command(const ReportOptions &options, const std::string &file) {
  std::vector<std::string> words{"report", "--output=" + file};
  if (!options.document.empty()) words.push_back("--document=" + options.document);
  for (const auto &[key, value] : options.head)
    if (!value.empty()) words.push_back("--" + key + "=" + value);
  if (options.pdf) words.emplace_back("--pdf");
  if (!options.language.empty()) words.push_back("--language=" + options.language);
  words.insert(words.end(), {"--", options.folder});
  return words;
}

/// Where the page goes: into the folder, or beside the mapping file.
std::string beside(const ReportOptions &options) {
  const auto measured = calibration::measured_name(options.folder);
  const std::string page = options.language.empty() ? "report.html" : "client-" + options.language + ".html";
  if (!measured) return (std::filesystem::path(options.folder) / page).string();
  const std::string stem = std::filesystem::path(measured->file).replace_extension().string();
  return stem + (measured->test.empty() ? "" : "-" + measured->test) + ".html";
}

void run_report(const ReportOptions &options, Console &console) {
  const std::string file = options.output.empty() ? beside(options) : options.output;
  const int code = python(command(options, file));
  if (code == static_cast<int>(ExitCode::input)) throw InputError(options.folder + ": no report was made");
  if (code == static_cast<int>(ExitCode::data)) throw DataError(options.folder + ": no report could be made of it");
  if (code != 0) throw IoError(fmt::format("the report was not written (python3 -m report ended with {})", code));
  console.data(file + "\n");
  const std::string pdf = std::filesystem::path(file).replace_extension(".pdf").string();
  if (options.pdf && std::filesystem::exists(pdf))
    console.data(pdf + "\n"); // without a browser Python said why there is none
}

void add_report(CLI::App &verb, Console &console) {
  auto options = std::make_shared<ReportOptions>();
  verb.add_option(
          "DIR", options->folder,
          "results of `main`, a calibration, a run, building, sweep or study folder; or a laboratory's mapping file")
      ->required();
  verb.add_option("-o,--output", options->output,
                  "the HTML file (default DIR/report.html, of a mapping file beside it)");
  for (const char *key : {"title", "client", "project", "author"})
    verb.add_option(std::string("--") + key, options->head[key], "on the first page");
  verb.add_option("--document", options->document, "a TOML file with title, client, project and author");
  verb.add_option("--language", options->language,
                  "two pages for the client in its place, client-LANGUAGE.html: words in this language")
      ->check(CLI::IsMember({"en", "es", "it", "ja", "tr"}));
  verb.add_flag("--pdf", options->pdf, "a PDF beside the HTML file, printed by Chromium where it is installed");
  console.add_common(verb);
  verb.callback([options, &console] { run_report(*options, console); });
}

} // namespace

const Verb report_verb{{.name = "report",
                        .help = "one self-contained HTML file of a results, calibration or run folder",
                        .examples = "rimpact report my-run\nrimpact report results/main --pdf",
                        .next = "open the page that is named above in a browser"},
                       add_report};

} // namespace rimpact::app

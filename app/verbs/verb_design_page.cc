// rimpact design-page DIR: one page with sliders over the rims that `geometry --vary` has pushed.
#include "app/console/child_process.h"
#include "app/verbs/catalogue.h"
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

void run_design_page(const std::string &folder, const std::string &output, Console &console) {
  const std::string file = output.empty() ? (std::filesystem::path(folder) / "design.html").string() : output;
  const int code = python({"report.design_page", "--output=" + file, "--", folder});
  if (code == static_cast<int>(ExitCode::input)) throw InputError(folder + ": no page was made");
  if (code == static_cast<int>(ExitCode::data)) throw DataError(folder + ": no page could be made of it");
  if (code != 0) throw IoError(fmt::format("the page was not written (python3 -m report.design_page: {})", code));
  console.data(file + "\n");
}

void add_design_page(CLI::App &verb, Console &console) {
  auto folder = std::make_shared<std::string>(), output = std::make_shared<std::string>();
  verb.add_option("DIR", *folder, "folder of `geometry CASE --vary ...`")->required();
  verb.add_option("-o,--output", *output, "the HTML file (default DIR/design.html)");
  console.add_common(verb);
  verb.callback([folder, output, &console] { run_design_page(*folder, *output, console); });
}

} // namespace

const Verb design_page_verb{{.name = "design-page",
                             .help = "one HTML page with sliders over the rims of `geometry --vary`",
                             .examples = "rimpact design-page results/geometry",
                             .next = "open the page that is named above in a browser"},
                            add_design_page};

} // namespace rimpact::app

// rimpact report DIR: one self-contained HTML file.
#include "app/sibling.h"
#include "app/verb.h"
#include <fmt/format.h>

namespace rimpact::app {

void add_report(CLI::App &app, Console &console) {
  struct Options {
    std::string folder, output;
  };
  auto *verb = app.add_subcommand("report", "one self-contained HTML file of a results or run folder");
  auto options = std::make_shared<Options>();
  verb->add_option("DIR", options->folder, "results of `main`, or one run folder")->required();
  verb->add_option("-o,--output", options->output, "the HTML file (default DIR/report.html)");
  console.add_common(*verb);
  verb->callback([options, &console] {
    const std::string file = options->output.empty() ? options->folder + "/report.html" : options->output;
    const int code = python({"report", options->folder, "--output", file});
    if (code == 3) throw DataError(options->folder + ": no report could be made of it");
    if (code != 0)
      throw IoError(fmt::format("the report was not written (python3 -m report ended with {})", code));
    console.data(file + "\n");
  });
}

} // namespace rimpact::app

// rimpact help [VERB]: main_light.cc turns `help VERB` into `VERB --help`, so that every verb answers for itself.
#include "app/verbs/catalogue.h"
#include <algorithm>

namespace rimpact::app {
namespace {

void add_help(CLI::App &verb, Console &console) {
  std::vector<std::string> names;
  for (const Verb *each : light_verbs()) names.emplace_back(each->text.name);
  verb.add_option("VERB", "whose; without it, all verbs")->check(CLI::IsMember(names));
  console.add_common(verb);
  verb.callback([&app = *verb.get_parent(), &console] { // app.help() would be that of the verb that was parsed
    console.data(app.get_formatter()->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal));
  });
}

} // namespace

const Verb help_verb{{.name = "help",
                      .help = "a verb's options, examples and exit codes",
                      .examples = "rimpact help\nrimpact help calibrate"},
                     add_help};

} // namespace rimpact::app

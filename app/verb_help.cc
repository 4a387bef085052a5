// rimpact help [VERB]: main_light.cc turns `help VERB` into `VERB --help`, so that every verb answers for itself.
#include "app/catalogue.h"
#include <algorithm>

namespace rimpact::app {

void add_help(CLI::App &app, Console &console) {
  auto *verb = app.add_subcommand("help", "a verb's options, examples and exit codes");
  std::vector<std::string> names;
  for (const auto &each : light_verbs()) names.emplace_back(each.name);
  verb->add_option("VERB", "whose; without it, all verbs")->check(CLI::IsMember(names));
  console.add_common(*verb);
  verb->callback([&app, &console] { // app.help() would be that of the verb that was parsed, which is this one
    console.data(app.get_formatter()->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal));
  });
}

std::vector<std::string> without_help(int argc, char **argv) {
  std::vector<std::string> words(argv, argv + argc);
  const auto &verbs = light_verbs();
  const auto is_verb = [&](const Verb &each) { return words[2] == each.name; };
  if (argc == 3 && words[1] == "help" && std::any_of(verbs.begin(), verbs.end(), is_verb))
    words = {words[0], words[2], "--help"};
  return words;
}

} // namespace rimpact::app

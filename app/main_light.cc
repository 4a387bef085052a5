// The light executable: everything but finite elements, which it hands to rimpact-fe.
#include "app/console/child_process.h"
#include "app/console/command.h"
#include "app/jobs/rank_launcher.h"
#include "app/verbs/catalogue.h"
#include "io/files/library_threads.h"

#include <algorithm>
#include <fmt/format.h>

namespace {

/// `help VERB` is `VERB --help`.
std::vector<std::string> without_help(int argc, char **argv) {
  std::vector<std::string> words(argv, argv + argc);
  const auto verbs = rimpact::app::light_verbs();
  const auto is_verb = [&](const rimpact::app::Verb *each) { return words[2] == each->text.name; };
  if (argc == 3 && words[1] == "help" && std::ranges::any_of(verbs, is_verb)) words = {words[0], words[2], "--help"};
  return words;
}

/// Whether the finite-element program carries the verb out. It tells the versions of all libraries, where it is there.
bool is_elsewhere(const std::string &verb) {
  using namespace rimpact::app;
  if (verb == version_verb.text.name) return has_fe_program();
  return std::ranges::any_of(light_verbs(), [&](const Verb *each) { return !each->add && verb == each->text.name; });
}

} // namespace

int main(int argc, char **argv) {
  using namespace rimpact;
  app::open_standard_streams();
  ask_for_one_library_thread(); // of every program started from here
  auto line = without_help(argc, argv);
  if (line.size() > 1 && is_elsewhere(line[1])) {
    try {
      std::vector<std::string> words(line.begin() + 1, line.end());
      if (words[0] == "run") {
        const auto asked = app::take_ranks(words);
        const int ranks = asked ? *asked : app::usual_ranks(words);
        if (ranks > 1) return app::run_on_ranks(ranks, app::fe_program(), words);
      }
      app::exec_fe(words);
    } catch (const Error &error) {
      app::say(fmt::format("error: {}\n", error.what()));
      return static_cast<int>(error.code());
    }
  }
  std::vector<char *> pointers;
  for (auto &word : line) pointers.push_back(word.data());
  return app::run_command(static_cast<int>(pointers.size()), pointers.data(), app::light_verbs());
}

// The light executable: everything but finite elements, which it hands to its sibling.
#include "app/catalogue.h"
#include "app/console.h"
#include "app/rank_launcher.h"
#include "app/sibling.h"
#include "files/library_threads.h"

#include <fmt/format.h>
#include <set>

int main(int argc, char **argv) {
  using namespace rimpact;
  app::open_standard_streams();
  ask_for_one_library_thread(); // of every program started from here
  static const std::set<std::string> elsewhere{"run", "mesh", "curve", "version"};
  auto line = app::without_help(argc, argv);
  if (line.size() > 1 && elsewhere.count(line[1]) && (line[1] != "version" || app::has_fe_program())) {
    try {
      std::vector<std::string> words(line.begin() + 1, line.end());
      if (words[0] == "run") {
        const auto asked = app::take_ranks(words);
        const int ranks = asked ? *asked : app::usual_ranks(words);
        if (ranks > 1) return app::run_on_ranks(ranks, app::fe_program(), words);
      }
      app::become_fe(words);
    } catch (const Error &error) {
      app::say(fmt::format("error: {}\n", error.what()));
      return static_cast<int>(error.code());
    }
  }
  std::vector<char *> pointers;
  for (auto &word : line) pointers.push_back(word.data());
  return app::run_command(static_cast<int>(pointers.size()), pointers.data(), app::light_verbs());
}

// The light executable: everything but finite elements, which it hands to its sibling.
#include "app/catalogue.h"
#include "app/console.h"
#include "app/rank_launcher.h"
#include "app/sibling.h"

#include <fmt/format.h>
#include <set>

int main(int argc, char **argv) {
  using namespace rimpact;
  app::open_standard_streams();
  static const std::set<std::string> elsewhere{"run", "mesh", "curve", "version"};
  if (argc > 1 && elsewhere.count(argv[1])) {
    try {
      std::vector<std::string> words(argv + 1, argv + argc);
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
  return app::run_command(argc, argv, app::light_verbs());
}

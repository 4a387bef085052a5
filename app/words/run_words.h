/// The words of `rimpact run`: read by rimpact-fe, which runs them, and by rimpact, which wants to know on how many
/// ranks.
#pragma once
#include "app/console/console.h"
#include <string>

namespace rimpact::app {

struct RunWords {
  std::string scene, folder;
  bool resume = false, dry_run = false, no_fields = false;
  double fields_every_ms = 0;
};

void add_run_words(CLI::App &verb, RunWords &words, Console &console);

} // namespace rimpact::app

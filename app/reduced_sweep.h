/// rimpact reduced SCENE --sweep FILE: a fleet of runs.
#pragma once
#include "app/console.h"
#include <string>

namespace rimpact::app {

struct SweepOptions {
  std::string scene;
  std::vector<std::string> sweep; ///< one file, or KEY=a:b:n each
  std::string folder;
  std::string shard; ///< "i/n", empty: all
  int n_threads = 0;
  bool picture = false;
};
void reduced_sweep(const SweepOptions &options, Console &console);

} // namespace rimpact::app

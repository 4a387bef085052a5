/// The command's verbs and options as data: what completions are made from.
#pragma once
#include "app/console/console.h"
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace rimpact::app {

struct OptionWords {
  std::vector<std::string> names; ///< "--set", "-o"; empty: an argument by place
  std::string description;
  std::vector<std::string> values; ///< what it may be, where that is a list
  bool takes_value = false;
};
struct VerbWords {
  std::string name, description;
  std::vector<OptionWords> options;
};
/// Every verb but the hidden ones.
std::vector<VerbWords> command_tree(const CLI::App &app);

/// The verb `completion` of both programs.

} // namespace rimpact::app

/// What every verb's --help ends with, and what may be done after it.
#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace rimpact::app {

/// Gives each subcommand its examples and the exit codes as footer.
void add_words(CLI::App &app);
/// Of the run this process writes: where the next step finds it.
void remember_folder(const std::string &folder);
/// One command to go on with after the verb, in the folder remembered, else in `named`, the one on the command line.
/// Empty: nothing follows.
std::string next_step(const std::string &verb, const std::string &named);

} // namespace rimpact::app

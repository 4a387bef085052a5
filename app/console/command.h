/// The command line: parses it, runs the verb, and turns every failure into one sentence and its exit code.
#pragma once
#include "app/console/verb.h"
#include <span>

namespace rimpact::app {

/// Returns the exit code (docs/interface.md).
int run_command(int argc, char **argv, std::span<const Verb *const> verbs);

} // namespace rimpact::app

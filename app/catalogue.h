/// The verbs of the light executable.
#pragma once
#include "app/verb.h"

namespace rimpact::app {
const std::vector<Verb> &light_verbs();

/// The command line; `help VERB` as `VERB --help`.
std::vector<std::string> without_help(int argc, char **argv);
} // namespace rimpact::app

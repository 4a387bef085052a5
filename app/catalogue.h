/// The verbs of the light executable.
#pragma once
#include "app/verb.h"

namespace rimpact::app {
const std::vector<Verb> &light_verbs();
} // namespace rimpact::app

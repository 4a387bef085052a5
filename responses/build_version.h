/// What made a file: version and commit of this build.
#pragma once
#include <string>

namespace rimpact {

std::string build_version(); ///< "rimpact 1.0.0, commit 0123456789ab"

} // namespace rimpact
